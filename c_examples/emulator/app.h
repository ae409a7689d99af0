/* The main window: four pages, the scene as its document, and the flight. */
#pragma once
#include "exchange.h"
#include "flight.h"
#include "plot.h"

class App;

/* A page of the main window: its fields go into the scene as soon as they are left. */
class Page : public ExchangeDialog {
public:
    explicit Page(App &app) : app_(app) {}
    /* Shows the scene; all_is_new: what was typed wrong goes too. */
    virtual void refresh(bool all_is_new);
    bool has_faults() const { return has_marks(); }

protected:
    void on_command(int id, int code) override;
    virtual void before_store(int) {}
    App &app_;
};

class TrajectoryPage : public Page {
public:
    using Page::Page;
    void refresh(bool all_is_new) override;

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_notify(NMHDR *notice) override;

private:
    void set_source(int source);
    void edit(int id);
    void preview();
    Plot track_, profile_;
    std::wstring previewed_; /* the scene that the preview shows */
};

class GeneralPage : public Page {
public:
    using Page::Page;
    void refresh(bool all_is_new) override;

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_notify(NMHDR *notice) override;
    void before_store(int id) override;

private:
    std::string section() const;
    const Key *effect() const;
    void choose_effect();
    std::vector<const Key *> effects_;
};

class InsPage : public Page {
public:
    using Page::Page;

protected:
    void on_init() override;
};

class DisplayPage : public Page {
public:
    using Page::Page;
    void refresh(bool all_is_new) override;
    void update(const Flight *flight); /* draws what was flown */
    double pace() const;
    const Plot &plot() const { return plot_; }

protected:
    void on_init() override;
    void on_command(int id, int code) override;

private:
    void show_values(const Flight::Status &status);
    Plot plot_;
};

class App {
public:
    App();
    int run(HINSTANCE instance);
    /* The scene was edited: the sentence of a fault, or "". */
    void edited(const std::wstring &fault);
    void say_line(const std::wstring &sentence); /* in the status line */
    void command(int id);
    bool open(const std::wstring &path);
    void open_builtin(const std::string &name);
    std::wstring folder() const { return folder_of(path_); }
    HWND window() const { return window_; }
    Flight *flight() { return flight_.get(); }

    Scene scene;

private:
    static LRESULT CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    LRESULT handle(UINT message, WPARAM wparam, LPARAM lparam);
    void build();
    void layout();
    void show_page(int index);
    void replaced(const std::wstring &path);
    bool save(bool ask);
    bool may_discard();
    bool fly();
    void change_language(WORD language);
    void export_records(const std::wstring &path);
    bool is_input(const std::wstring &path) const;
    void remember(const std::wstring &path);
    void show_title();
    void automatic();
    void finish_automatic();
    void leave_field();

    HWND window_ = NULL, tabs_ = NULL, status_ = NULL;
    std::unique_ptr<Page> pages_[4];
    DisplayPage *display_ = NULL;
    std::unique_ptr<Flight> flight_;
    std::wstring path_;
    std::string saved_; /* text of the scene as it was opened or saved */
    std::vector<std::wstring> builtins_, recent_;
    bool runs_ = false;                         /* /run */
    std::wstring export_folder_, picture_path_; /* of the command line */
};

/* What the program keeps from run to run: "Language", "Recent". */
std::wstring registry_text(const wchar_t *name);
void set_registry_text(const wchar_t *name, const std::wstring &value);

/* A manoeuvre with its sinusoids; false: cancelled. */
bool edit_manoeuvre(App &app, Items &manoeuvre, const std::function<std::vector<Fault>(const Items &)> &take);
void edit_failures(App &app);
void recommend(App &app);
void error_budget(App &app);
