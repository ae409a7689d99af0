#include "scene.h"

std::wstring last_error(const sins_sim *sim)
{
    sins_error_info info = sized<sins_error_info>();
    const uint32_t LIMITS = SINS_ERROR_INFO_VALUE | SINS_ERROR_INFO_MINIMUM | SINS_ERROR_INFO_MAXIMUM;
    lib.sins_last_error_info(sim, &info);
    if (is_chinese() && (info.flags & LIMITS) == LIMITS) {
        const Key *key = key_of(info.field);
        std::wstring field =
            key == NULL ? wide(info.field) : label(key->path(), key->doc) + L" (" + wide(info.field) + L")";
        return text("limits", {field, shown(info.value, 6), shown(info.minimum, 6), shown(info.maximum, 6)});
    }
    return wide(whole_text([sim](char *buffer, size_t size, size_t *needed) {
        return lib.sins_last_error(sim, buffer, size, needed);
    }));
}

std::wstring told(const Faults &faults)
{
    return faults.empty() ? L"" : told(faults[0].sentence);
}

/* A value without the comment that the library writes behind it. */
static std::string without_comment(const std::string &text)
{
    char quote = text.empty() ? '\0' : text[0];
    if (quote != '"' && quote != '\'') {
        return text.substr(0, text.find("  #"));
    }
    size_t end = 1;
    while (end < text.size() && text[end] != quote) {
        end += quote == '"' && text[end] == '\\' ? 2 : 1;
    }
    return text.substr(0, end + 1);
}

/* The sections of a text that the library wrote: one key a line. */
static Items items_of(const std::string &text)
{
    Items items;
    Item *last = NULL;
    for (const std::string &line : split(text, "\n")) {
        size_t equals = line.find(" = ");
        if (begins(line, "[")) {
            size_t first = line.find_first_not_of('[');
            std::string section = line.substr(first, line.find(']') - first);
            Items &all =
                !items.empty() && begins(section, items.back().section + ".") ? items.back().items : items;
            all.push_back({section, {}, {}});
            last = &all.back();
        } else if (!begins(line, "#") && equals != std::string::npos && last != NULL) {
            last->entries.push_back({line.substr(0, equals), without_comment(line.substr(equals + 3))});
        }
    }
    return items;
}

Scene::Scene(const std::string &builtin)
{
    if (builtin.empty()) {
        lib.sins_scene_create(&handle_);
    } else {
        lib.sins_scene_create_builtin(builtin.c_str(), &handle_);
    }
    write_back();
}

void Scene::write_back()
{
    text_ = whole_text([this](char *buffer, size_t size, size_t *needed) {
        return lib.sins_scene_write(handle_, buffer, size, needed);
    });
    items_ = items_of(text_);
}

std::wstring Scene::taken(sins_status status)
{
    if (status < 0) {
        return last_error();
    }
    write_back();
    return L"";
}

std::wstring Scene::set_text(int which, const std::string &text)
{
    return taken(lib.sins_scene_set_text(handle_, which, text.c_str()));
}

Faults Scene::read(const std::string &text)
{
    Handle<sins_scene> handle;
    Faults faults;
    sins_fault fault = sized<sins_fault>();
    sins_status status = lib.sins_scene_parse(text.data(), text.size(), &handle);
    if (status == SINS_OK) {
        handle_ = std::move(handle);
        write_back();
    } else if (status < 0) {
        faults.push_back({0, "", narrow(last_error())});
    }
    while (status == SINS_SCENE_HAS_FAULTS &&
           lib.sins_scene_get_fault(handle, faults.size(), &fault) == SINS_OK) {
        faults.push_back({(size_t)fault.line, "", fault.sentence});
    }
    return faults;
}

/* The lines of an item, and of each the item's number with the path of its key. */
static void write_item(const Item &item, size_t number, std::string &text, Faults &lines)
{
    bool is_list = begins(item.section, "manoeuvre") || item.section == "failure";
    text += (is_list ? "[[" + item.section + "]]" : "[" + item.section + "]") + "\n";
    lines.push_back({number, item.section, ""});
    for (const auto &entry : item.entries) {
        text += entry.first + " = " + entry.second + "\n";
        lines.push_back({number, item.section + "." + entry.first, ""});
    }
    for (const Item &own : item.items) {
        write_item(own, number, text, lines);
    }
}

Faults Scene::read(const Items &items)
{
    Faults lines(1, {(size_t)-1, "", ""});
    std::string text;
    for (size_t k = 0; k < items.size(); k++) {
        write_item(items[k], k, text, lines);
    }
    Faults faults = read(text);
    for (Fault &fault : faults) {
        const Fault &line = lines[fault.item < lines.size() ? fault.item : 0];
        fault = {line.item, line.path, fault.sentence};
    }
    return faults;
}

std::string Scene::get(const std::string &path) const
{
    const Key *key = key_of(path);
    for (const Item &item : items_) {
        if (item.section == key->section) {
            return item.get(*key);
        }
    }
    return "";
}

Faults Scene::change(std::vector<Change> changes)
{
    Faults all;
    for (;;) {
        Items items = items_;
        for (const Change &change : changes) {
            std::string section = key_of(change.path)->section;
            auto own = std::find_if(items.begin(), items.end(),
                                    [&](const Item &item) { return item.section == section; });
            own = own == items.end() ? items.insert(own, {section, {}, {}}) : own;
            own->set(change.path, change.value, change.in_si);
        }
        /* The faults of all changes together count; without those at fault the others are tried again. */
        Faults faults = read(items);
        all = all.empty() ? faults : all;
        auto is_at_fault = [&](const Change &change) {
            return std::any_of(faults.begin(), faults.end(),
                               [&](const Fault &fault) { return key_of(fault.path) == key_of(change.path); });
        };
        auto sound = std::remove_if(changes.begin(), changes.end(), is_at_fault);
        if (sound == changes.begin() || sound == changes.end()) {
            return all;
        }
        changes.erase(sound, changes.end());
    }
}

Items Scene::list(const std::string &section) const
{
    Items items;
    std::copy_if(items_.begin(), items_.end(), std::back_inserter(items),
                 [&](const Item &item) { return item.section == section; });
    return items;
}

Faults Scene::set_list(const std::string &section, const Items &items)
{
    Items all;
    std::copy_if(items_.begin(), items_.end(), std::back_inserter(all),
                 [&](const Item &item) { return item.section != section; });
    size_t first = all.size();
    all.insert(all.end(), items.begin(), items.end());
    Faults faults = read(all);
    for (Fault &fault : faults) {
        fault.item -= first;
    }
    return faults;
}

sins_scene_setup Scene::setup() const
{
    sins_scene_setup setup = sized<sins_scene_setup>();
    lib.sins_scene_get_setup(handle_, &setup);
    return setup;
}

std::string Scene::words(int which) const
{
    return whole_text([&](char *buffer, size_t size, size_t *needed) {
        return lib.sins_scene_get_text(handle_, which, buffer, size, needed);
    });
}
