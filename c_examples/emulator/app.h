/* The main window: four pages, the scene as its document, and the flight. */
#pragma once
#include "flight.h"
#include "form.h"
#include "plot.h"

class App;

/* A page of the main window: its fields go into the scene as soon as they are left. */
class Page : public Form {
public:
    explicit Page(App &app) : app_(app) {}
    /* Shows the scene; all_is_new: what was typed wrong goes too. */
    virtual void refresh(bool all_is_new);

protected:
    void on_change(int id, int code) override;
    void on_refusal(const std::wstring &sentence) override; /* in the status line */
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

/* What stays when the window is built again in the other language. */
struct Document {
    Scene scene{"simulation2"};
    fs::path path;
    std::string saved = scene.text(); /* as it was opened or saved */
    std::unique_ptr<Flight> flight;
    RECT place = {}; /* of the window */
    int page = 0;
    /* Of the command line. */
    Texts arguments;
    fs::path export_folder, picture_path;
};

class App : public Dialog {
public:
    explicit App(Document &document);
    bool run();                                  /* true: the language changed, and a new window follows */
    void edited(const std::wstring &fault);      /* the scene was edited: the sentence of a fault, or "" */
    void say_line(const std::wstring &sentence); /* in the status line */
    void command(int id);
    void open_builtin(const std::string &name);
    fs::path folder() const { return document_.path.parent_path(); }
    Flight *flight() { return document_.flight.get(); }

    Texts builtins;
    Scene &scene;

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_notify(NMHDR *notice) override;
    bool on_message(UINT message, WPARAM wparam, LPARAM lparam) override;

private:
    void build_menu();
    void layout();
    void show_all();
    void show_page(int index);
    void show_title();
    void change_language(bool chinese);
    void leave_field();
    void open(const fs::path &path);
    void replaced(const fs::path &path);
    bool save(bool ask);
    bool may_discard();
    void remember(const fs::path &path);
    void fly();
    void export_records(const fs::path &path);
    void save_picture(const fs::path &path);
    void refuse_input(const fs::path &path);
    void follow_command_line();
    void finish_unattended();

    Document &document_;
    std::unique_ptr<Page> pages_[4];
    DisplayPage *display_ = new DisplayPage(*this); /* the last of them */
    Texts recent_;
    bool changes_language_ = false;
};

/* What the program keeps from run to run: "Language", "Recent". */
std::wstring registry_text(const wchar_t *name);
void set_registry_text(const wchar_t *name, const std::wstring &value);

/* Edits one of these manoeuvres, and sets them; false: cancelled. */
bool edit_manoeuvre(App &app, Items &all, size_t own);
void edit_failures(App &app);
void recommend(App &app);
void error_budget(App &app);
