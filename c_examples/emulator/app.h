/* The main window: four pages, the scene as its document, and the flight. */
#pragma once
#include "dialog.h"
#include "flight.h"
#include "plot.h"

class App;

/* A page of the main window: its fields go into the scene as soon as they are left. */
class Page : public Dialog {
public:
    explicit Page(App &app) : app_(app) {}
    /* Shows the scene; all_is_new: what was typed wrong goes too. */
    virtual void refresh(bool all_is_new);

protected:
    void on_change(int id, int code) override;
    App &app_;
};

Page *trajectory_page(App &app);
Page *general_page(App &app);

class DisplayPage : public Page {
public:
    using Page::Page;
    void refresh(bool) override { update(); }
    void update(); /* draws what was flown */
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
    void open_builtin(const std::string &name);
    std::wstring folder() const { return folder_of(path_); }
    const Texts &builtins() const { return builtins_; }
    HWND window() const { return window_; }
    Flight *flight() { return flight_.get(); }

    Scene scene;

private:
    static LRESULT CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    LRESULT handle(UINT message, WPARAM wparam, LPARAM lparam);
    void create_window(HINSTANCE instance);
    void build();
    void build_menu();
    void layout();
    void show_page(int index);
    void show_title();
    void change_language(bool chinese);
    void leave_field();

    /* The document. */
    bool open(const std::wstring &path);
    void replaced(const std::wstring &path);
    bool save(bool ask);
    bool may_discard();
    void remember(const std::wstring &path);
    void fly();
    void export_records(const std::wstring &path);
    void save_picture(const std::wstring &path);
    bool is_input(const std::wstring &path) const;
    void follow_command_line();
    void finish_unattended();

    HWND window_ = NULL, tabs_ = NULL, status_ = NULL;
    std::unique_ptr<Page> pages_[4];
    DisplayPage *display_ = NULL; /* the last of them */
    std::unique_ptr<Flight> flight_;
    std::wstring path_;
    std::string saved_; /* text of the scene as it was opened or saved */
    Texts builtins_, recent_;
    bool runs_ = false;                         /* /run */
    std::wstring export_folder_, picture_path_; /* of the command line */
};

/* What the program keeps from run to run: "Language", "Recent". */
std::wstring registry_text(const wchar_t *name);
void set_registry_text(const wchar_t *name, const std::wstring &value);

/* Edits one of these manoeuvres, and sets them; false: cancelled. */
bool edit_manoeuvre(App &app, Items &all, size_t own);
void edit_failures(App &app);
void recommend(App &app);
void error_budget(App &app);
