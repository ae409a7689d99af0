/* The document of the pages and dialogs: the scene, its file and its flight. */
#pragma once
#include "flight.h"
#include "form.h"
#include "plot.h"

/* Settings that the program keeps between runs: "Language", "Recent". */
inline const wchar_t REGISTRY[] = L"Software\\SINS_Emulator";

inline std::wstring registry_text(const wchar_t *name) {
    WCHAR value[16384] = L"";
    DWORD size = sizeof value;
    RegGetValueW(HKEY_CURRENT_USER, REGISTRY, name, RRF_RT_REG_SZ, NULL, value, &size);
    return value;
}

inline void set_registry_text(const wchar_t *name, const std::wstring &value) {
    DWORD size = (DWORD)((value.size() + 1) * sizeof(WCHAR));
    RegSetKeyValueW(HKEY_CURRENT_USER, REGISTRY, name, REG_SZ, value.c_str(), size);
}

class Document {
public:
    virtual void edited(const std::wstring &fault) = 0; /* the scene was edited; fault: sentence, or "" */
    virtual void named(bool is_other) = 0;              /* the scene has a file; is_other: it is another scene */
    virtual bool may_discard() = 0;                     /* whether unsaved changes may be lost */
    virtual void say_line(const std::wstring &sentence) = 0; /* in the status line */
    virtual void command(int id) = 0;

    static Texts builtins() { /* names of the built-in scenes */
        Texts names;
        for (const std::string &name : sins::Scene::builtin_names())
            names.push_back(wide(name));
        return names;
    }

    bool is_saved() const { return scene.write() == saved_; }
    fs::path folder() const { return path.parent_path(); }

    /* A built-in scene by its name; "": the default scene. */
    void open_builtin(const std::string &name) {
        if (may_discard())
            replace(name.empty() ? sins::Scene() : sins::Scene::builtin(name), L"");
    }

    /* A scene, or a log for this scene's simulator. */
    void open(const fs::path &file) {
        if (file.empty())
            return;
        for (const wchar_t *of_log : {L".csv", L".igc", L".gpx", L".fdr"})
            if (lstrcmpiW(file.extension().c_str(), of_log) == 0) {
                fly_log(file);
                return;
            }
        sins::Scene read(read_file(file));
        std::wstring why;
        for (const sins_fault &fault : read.faults())
            why += file.wstring() + L":" + std::to_wstring(fault.line) + L": " + told(fault) + L"\n";
        if (!why.empty())
            throw Refusal(why.substr(0, 2000));
        replace(std::move(read), file);
    }

    /* The path of a log is relative to the scene's folder if the log is in or below this folder. */
    void fly_log(const fs::path &log) {
        is_live = false;
        fs::path seen = log.lexically_relative(folder());
        bool is_below = !seen.empty() && *seen.begin() != L"..";
        edited(told(scene.set({{"flight.file", in_quotes(narrow(is_below ? seen : log))}})));
    }

    /* Saves into a file. Without a name, the user names the file. */
    bool save(fs::path file) {
        std::wstring log = wide(scene.text(SINS_SCENE_TEXT_LOG));
        if (file.empty())
            file = ask_file(GetActiveWindow(), true, "filter_scene", L"toml", path);
        if (file.empty())
            return false;
        if (same_file(file, folder() / log))
            throw Refusal(text("is_input", {file}));
        if (!log.empty() && file.parent_path() != folder()) /* the path of a log is relative to the scene's folder */
            scene.set({{"flight.file", in_quotes(narrow(folder() / log))}});
        write_file(file, [this](const fs::path &to) {
            std::ofstream stream(to, std::ios::binary);
            return (stream << scene.write()).flush().good();
        });
        remember(file);
        named(false);
        return true;
    }

    /* An output must not replace the scene or the log of its flight. */
    void refuse_input(const fs::path &file) {
        if (same_file(file, path) || same_file(file, flight->log_path()))
            throw Refusal(text("is_input", {file}));
    }

    /* Writes the records, and into the same folder the measured increments if the scene names a
     * file for them. */
    void export_records(const fs::path &file) {
        fs::path name = flight->increments_name(), increments = file.parent_path() / name;
        if (file.empty())
            return;
        refuse_input(file);
        flight->write(file, false);
        if (name.empty())
            return;
        if (name != name.filename() || increments == file)
            throw Refusal(text("increments_name", {name}));
        refuse_input(increments);
        flight->write(increments, true);
    }

    /* The scene that is flown, or faults(). Packets replace its flight, and those without a time have a stated period. */
    Scene flown() const {
        Scene flown(scene);
        Changes changes = {{"flight.file", in_quotes("live")}, {"flight.hours", ""}};
        if (is_live && !live_source.has_time)
            changes["options.sample_period_s"] = shortest(1 / live_source.rate_hz);
        if (is_live)
            flown.set(changes);
        return flown;
    }

    Scene scene{sins::Scene::builtin("simulation2")};
    bool is_live = false; /* whether packets are flown instead of the flight of the scene */
    LiveSource live_source;
    fs::path path;
    std::unique_ptr<Flight> flight;

protected:
    ~Document() = default;

    /* Notes the scene before a change, for undo(). */
    void note_change() {
        std::string now = scene.write();
        if (now != current_)
            earlier_.push_back(std::exchange(current_, now));
    }

    /* Takes the last change of the scene back. */
    void undo() {
        if (earlier_.empty())
            return;
        current_ = std::move(earlier_.back());
        earlier_.pop_back();
        scene = sins::Scene(current_);
        if (flight != NULL)
            flight->plan(scene);
    }

    Texts recent_ = split(registry_text(L"Recent"), L'|'); /* recently opened files */

private:
    void replace(sins::Scene &&other, const fs::path &file) {
        scene = std::move(other);
        is_live = false;
        earlier_.clear();
        flight.reset();
        remember(file);
        named(true);
    }

    /* Notes that this file has the current scene. */
    void remember(const fs::path &file) {
        path = file;
        saved_ = current_ = scene.write();
        if (file.empty())
            return;
        std::erase(recent_, file.wstring());
        recent_.insert(recent_.begin(), file.wstring());
        recent_.resize(min(recent_.size(), (size_t)8));
        std::wstring all;
        for (const std::wstring &own : recent_)
            all += own + L"|";
        set_registry_text(L"Recent", all);
    }

    std::string current_ = scene.write();
    std::vector<std::string> earlier_; /* texts of the scene before its changes */
    std::string saved_ = current_; /* text of the scene when it was opened or saved */
};

/* A page of the main window. The value of a field is set in the scene when the user leaves the field. */
class Page : public Form {
public:
    explicit Page(Document &document) : Form(document.scene), document_(document) {}
    /* Shows the scene; all_is_new: rejected input is replaced too. */
    virtual void refresh(bool all_is_new) { load(all_is_new); }

protected:
    void on_change(int, int) override {
        if (!changes().empty() || has_marks())
            document_.edited(save());
    }

    void on_refusal(const std::wstring &sentence) override { document_.say_line(sentence); }

    Document &document_;
};
