#include "scene.h"

std::wstring last_error(const sins_sim *sim)
{
    sins_error_info info = sized<sins_error_info>();
    const uint32_t LIMITS = SINS_ERROR_INFO_VALUE | SINS_ERROR_INFO_MINIMUM | SINS_ERROR_INFO_MAXIMUM;
    lib.sins_last_error_info(sim, &info);
    if (is_chinese() && (info.flags & LIMITS) == LIMITS) {
        const Key *key = key_of(info.field);
        std::wstring field = wide(info.field), meaning = key == NULL ? L"" : label(key->path, key->doc);
        field = key == NULL ? field : meaning + L" (" + field + L")";
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

std::string Item::get(const std::string &path) const
{
    const Key &key = *key_of(path);
    for (const auto &[name, value] : entries) {
        if (name == key.name) {
            return value;
        }
        if (name == key.si_name) { /* no number in the key's unit is the same to the bit */
            std::vector<std::string> elements = numbers(value, key);
            double number;
            for (std::string &element : elements) {
                element = number_of(element, number) ? shortest(number * key.units_per_si()) : element;
            }
            return key.count > 1 ? list_of(elements) : elements[0];
        }
    }
    return "";
}

void Item::set(const std::string &path, const std::string &value, bool in_si)
{
    const Key &key = *key_of(path);
    std::erase_if(entries,
                  [&](auto &entry) { return entry.first == key.name || entry.first == key.si_name; });
    if (!value.empty()) {
        entries.push_back({in_si ? key.si_name : key.name, value});
    }
}

Texts Item::described() const
{
    std::wstring words, values;
    for (const auto &[name, value] : entries) {
        const Key &key = *key_of(section + "." + name);
        if (!key.words.empty()) {
            words += (words.empty() ? L"" : L" ") + key.word_label(unquoted(value));
        } else {
            values += (values.empty() ? L"" : L", ") + label(key.path + ".short", name) + L" ";
            values += wide(get(key.path)) + (key.unit.empty() ? L"" : L" " + wide(key.unit));
        }
    }
    return {words, values};
}

/* A value without the comment that the library writes behind it. */
static std::string without_comment(const std::string &value)
{
    size_t end = 1;
    if (value[0] != '"') {
        return value.substr(0, value.find("  #"));
    }
    while (end < value.size() && value[end] != '"') {
        end += value[end] == '\\' ? 2 : 1;
    }
    return value.substr(0, end + 1);
}

/* The sections of a text that the library wrote: one key a line. */
static Items items_of(const std::string &text)
{
    Items items;
    Item *last = NULL;
    for (const std::string &line : split(text, "\n")) {
        size_t equals = line.find(" = ");
        if (line.starts_with("[")) {
            size_t first = line.find_first_not_of('[');
            std::string section = line.substr(first, line.find(']') - first);
            bool is_nested = !items.empty() && section.starts_with(items.back().section + ".");
            Items &all = is_nested ? items.back().items : items;
            last = &all.emplace_back(Item{section, {}, {}});
        } else if (!line.starts_with("#") && equals != std::string::npos && last != NULL) {
            last->entries.push_back({line.substr(0, equals), without_comment(line.substr(equals + 3))});
        }
    }
    return items;
}

Scene::Scene(const std::string &builtin)
{
    bool is_default = builtin.empty();
    taken(is_default ? lib.sins_scene_create(&handle_)
                     : lib.sins_scene_create_builtin(builtin.c_str(), &handle_));
}

void Scene::taken(sins_status status)
{
    check(status);
    text_ = whole_text([this](char *buffer, size_t size, size_t *needed) {
        return lib.sins_scene_write(handle_, buffer, size, needed);
    });
    items_ = items_of(text_);
}

Faults Scene::read(const std::string &text)
{
    Handle<sins_scene> handle;
    Faults faults;
    sins_fault fault = sized<sins_fault>();
    sins_status status = check(lib.sins_scene_parse(text.data(), text.size(), &handle));
    while (status != SINS_OK && lib.sins_scene_get_fault(handle, faults.size(), &fault) == SINS_OK) {
        faults.push_back({(size_t)fault.line, 0, "", fault.sentence});
    }
    if (status == SINS_OK) {
        handle_ = std::move(handle);
        taken(status);
    }
    return faults;
}

/* The lines of an item; and of each what a fault in it is a fault of. */
static void write_item(const Item &item, size_t number, size_t nested, std::string &text, Faults &lines)
{
    bool is_list = item.section.starts_with("manoeuvre") || item.section == "failure";
    text += (is_list ? "[[" + item.section + "]]" : "[" + item.section + "]") + "\n";
    lines.push_back({number, nested, item.section, ""});
    for (const auto &[name, value] : item.entries) {
        text += name + " = " + value + "\n";
        lines.push_back({number, nested, item.section + "." + name, ""});
    }
    for (const Item &own : item.items) {
        nested++;
        if (!own.entries.empty()) {
            write_item(own, number, nested, text, lines);
        }
    }
}

Faults Scene::read(const Items &items)
{
    Faults lines(1, {(size_t)-1, 0, "", ""});
    std::string text;
    for (size_t k = 0; k < items.size(); k++) {
        write_item(items[k], k, 0, text, lines);
    }
    Faults faults = read(text);
    for (Fault &fault : faults) {
        const Fault &line = lines[fault.item < lines.size() ? fault.item : 0];
        fault = {line.item, line.nested, line.path, fault.sentence};
    }
    return faults;
}

std::string Scene::get(const std::string &path) const
{
    const std::string &section = key_of(path)->section;
    auto own =
        std::find_if(items_.begin(), items_.end(), [&](auto &item) { return item.section == section; });
    return own == items_.end() ? "" : own->get(path);
}

Faults Scene::change(std::vector<Change> changes)
{
    Items items = items_;
    for (const Change &change : changes) {
        const std::string &section = key_of(change.path)->section;
        auto own =
            std::find_if(items.begin(), items.end(), [&](auto &item) { return item.section == section; });
        own = own == items.end() ? items.insert(own, {section, {}, {}}) : own;
        own->set(change.path, change.value, change.in_si);
    }
    /* The faults of all changes together count; without those at fault the others are tried again. */
    Faults faults = read(items);
    size_t erased = std::erase_if(changes, [&](const Change &change) {
        return std::any_of(faults.begin(), faults.end(),
                           [&](const Fault &fault) { return key_of(fault.path) == key_of(change.path); });
    });
    if (erased > 0 && !changes.empty()) {
        change(changes);
    }
    return faults;
}

Items Scene::list(const std::string &section) const
{
    Items items = items_;
    std::erase_if(items, [&](const Item &item) { return item.section != section; });
    return items;
}

Faults Scene::set_list(const std::string &section, const Items &items)
{
    Items all = items_;
    std::erase_if(all, [&](const Item &item) { return item.section == section; });
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
