#include "scene.h"

std::string last_error(const sins_sim *sim)
{
    char sentence[1024] = "";
    lib.sins_last_error(sim, sentence, sizeof sentence, NULL);
    return sentence;
}

std::string Item::get(const Key &key) const
{
    for (const auto &entry : entries) {
        if (entry.first == key.name) {
            return entry.second;
        }
        if (!key.si_name.empty() && entry.first == key.si_name) { /* no number in the key's unit is the same to the bit */
            std::string list;
            double number;
            for (const std::string &element : numbers(entry.second, key)) {
                number = 0;
                number_of(element, number);
                list += (list.empty() ? "" : ", ") + shortest(number * key.units_per_si());
            }
            return key.count > 1 ? "[" + list + "]" : list;
        }
    }
    return "";
}

void Item::set(const Key &key, const std::string &value, bool in_si)
{
    for (size_t k = entries.size(); k-- > 0;) {
        if (entries[k].first == key.name || entries[k].first == key.si_name) {
            entries.erase(entries.begin() + k);
        }
    }
    if (!value.empty()) {
        entries.insert(key.name == "preset" ? entries.begin() : entries.end(), {in_si ? key.si_name : key.name, value});
    }
}

/* Where the value that begins a text ends: behind it the library writes a comment. */
static size_t value_end(const std::string &text)
{
    char quote = text.empty() ? '\0' : text[0];
    if (quote == '"' || quote == '\'') {
        size_t end = 1;
        while (end < text.size() && text[end] != quote) {
            end += quote == '"' && text[end] == '\\' ? 2 : 1;
        }
        return end + 1;
    }
    return text.find("  #");
}

/* Reads a text that the library wrote: a section or a key a line. */
static Items items_of(const std::string &text)
{
    Items items;
    for (const std::string &line : split(text, "\n")) {
        size_t equals = line.find(" = ");
        if (begins(line, "[")) {
            size_t first = line.find_first_not_of('[');
            items.push_back({line.substr(first, line.find(']') - first), {}});
        } else if (!begins(line, "#") && equals != std::string::npos && !items.empty()) {
            std::string value = line.substr(equals + 3);
            items.back().entries.push_back({line.substr(0, equals), value.substr(0, value_end(value))});
        }
    }
    return items;
}

static bool is_list(const std::string &section)
{
    return begins(section, "manoeuvre") || section == "failure";
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
    text_ = whole_text([this](char *buffer, size_t size, size_t *needed) { return lib.sins_scene_write(handle_, buffer, size, needed); });
    items_ = items_of(text_);
}

bool Scene::take(sins_status status)
{
    if (status >= 0) {
        write_back();
    }
    return status >= 0;
}

bool Scene::read(const std::string &text, std::vector<Fault> &faults)
{
    Handle<sins_scene> handle;
    sins_fault fault;
    sins_status status = lib.sins_scene_parse(text.data(), text.size(), &handle);
    if (status == SINS_OK) {
        handle_ = std::move(handle);
        write_back();
        return true;
    }
    SINS_INIT(fault);
    for (size_t k = 0; status == SINS_SCENE_HAS_FAULTS && lib.sins_scene_get_fault(handle, k, &fault) == SINS_OK; k++) {
        faults.push_back({(size_t)fault.line, "", fault.sentence}); /* the line: whoever made the text knows its item */
    }
    if (faults.empty()) {
        faults.push_back({0, "", last_error()});
    }
    return false;
}

bool Scene::read(const Items &items, std::vector<Fault> &faults)
{
    std::vector<std::pair<size_t, std::string>> lines(1, {(size_t)-1, ""}); /* item and path of each line, from 1 */
    std::string text;
    for (size_t k = 0; k < items.size(); k++) {
        const Item &item = items[k];
        text += (is_list(item.section) ? "[[" + item.section + "]]" : "[" + item.section + "]") + "\n";
        lines.push_back({k, item.section});
        for (const auto &entry : item.entries) {
            const Key *key = key_of(item.section + "." + entry.first);
            text += entry.first + " = " + entry.second + "\n";
            lines.push_back({k, key == NULL ? item.section : key->path()});
        }
    }
    if (read(text, faults)) {
        return true;
    }
    for (Fault &fault : faults) {
        size_t line = fault.item < lines.size() ? fault.item : 0;
        fault.item = lines[line].first;
        fault.path = lines[line].second;
    }
    return false;
}

std::string Scene::get(const std::string &path) const
{
    const Key *key = key_of(path);
    for (const Item &item : items_) {
        if (key != NULL && item.section == key->section) {
            return item.get(*key);
        }
    }
    return "";
}

std::vector<Fault> Scene::change(std::vector<Change> changes)
{
    std::vector<Fault> told;
    while (!changes.empty()) {
        Items items = items_;
        std::vector<Fault> faults;
        for (const Change &change : changes) {
            const Key *key = key_of(change.path);
            size_t k = 0;
            while (k < items.size() && items[k].section != key->section) {
                k++;
            }
            if (k == items.size()) {
                items.push_back({key->section, {}});
            }
            items[k].set(*key, change.value, change.in_si);
        }
        /* The faults of all changes together count; without those at fault the others are tried again. */
        if (read(items, faults)) {
            break;
        }
        size_t before = changes.size();
        for (const Fault &fault : faults) {
            for (size_t k = changes.size(); k-- > 0;) {
                if (key_of(changes[k].path) == key_of(fault.path)) {
                    changes.erase(changes.begin() + k);
                }
            }
        }
        told = told.empty() ? faults : told;
        if (changes.size() == before) {
            break;
        }
    }
    return told;
}

sins_scene_setup Scene::setup() const
{
    sins_scene_setup setup;
    SINS_INIT(setup);
    lib.sins_scene_get_setup(handle_, &setup);
    return setup;
}

std::string Scene::words(int which) const
{
    return whole_text([&](char *buffer, size_t size, size_t *needed) { return lib.sins_scene_get_text(handle_, which, buffer, size, needed); });
}

std::string quoted(const std::string &text)
{
    std::string result = "\"";
    for (unsigned char letter : text) {
        char escape[8] = {(char)letter, '\0'};
        if (letter == '"' || letter == '\\') {
            snprintf(escape, sizeof escape, "\\%c", letter);
        } else if (letter < ' ' || letter == 127) {
            snprintf(escape, sizeof escape, "\\u%04x", letter);
        }
        result += escape;
    }
    return result + "\"";
}

std::string unquoted(const std::string &value)
{
    std::string result;
    if (value.size() < 2 || (value[0] != '"' && value[0] != '\'')) {
        return value;
    }
    for (size_t k = 1; k + 1 < value.size(); k++) {
        k += value[0] == '"' && value[k] == '\\' ? 1 : 0;
        result += value[k];
    }
    return result;
}

std::vector<std::string> numbers(const std::string &value, const Key &key)
{
    std::vector<std::string> result((size_t)key.count, "");
    if (!begins(value, "[")) {
        for (int k = 0; k < key.count; k++) {
            result[k] = key.single_sets(k) ? value : "";
        }
        return result;
    }
    std::vector<std::string> list = split(value.substr(1, value.size() - 2), ", ");
    for (size_t k = 0; k < list.size() && k < result.size(); k++) {
        result[k] = list[k] == "0" || list[k] == "0.0" ? "" : list[k];
    }
    return result;
}
