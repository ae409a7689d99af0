/* The keys of a scene, as the library gives them, and the values that stand under them. */
#include <map>

#include "scene.h"

/* A number beyond every limit: the library's answer has the limits. */
static const char PROBE[] = "1e17";

/* "  name: doc; what it takes [unit]; in SI name": the doc may have semicolons of its own. */
static Key parse_key(const std::string &section, const std::string &line)
{
    Key key = {};
    size_t colon = line.find(": "), in_si = line.rfind("; in SI ");
    std::string rest = line.substr(colon + 2, in_si == std::string::npos ? in_si : in_si - colon - 2);
    size_t takes = rest.rfind("; ");
    key.section = section;
    key.name = line.substr(2, colon - 2);
    key.si_name = in_si == std::string::npos ? "" : line.substr(in_si + 8);
    key.doc = rest.substr(0, takes);
    key.takes = takes == std::string::npos ? "" : rest.substr(takes + 2);
    size_t unit = key.takes.rfind(" [");
    key.unit = unit == std::string::npos ? "" : key.takes.substr(unit + 2, key.takes.size() - unit - 3);
    if (key.takes.find('|') != std::string::npos) {
        key.words = split(key.takes, "|");
    } else if (key.takes == "true or false") {
        key.words = {"false", "true"};
    } else if (begins(key.takes, "a text")) {
        key.is_text = true;
    } else {
        bool is_matrix = key.takes.find("nine") != std::string::npos;
        key.count = is_matrix ? 9 : key.takes.find("three") != std::string::npos ? 3 : 1;
    }
    return key;
}

const std::vector<Key> &keys()
{
    static std::vector<Key> all;
    if (all.empty()) {
        std::string section;
        for (const std::string &line : split(whole_text(lib.sins_scene_write_keys), "\n")) {
            if (begins(line, "[")) {
                size_t first = line.find_first_not_of('[');
                section = line.substr(first, line.find(']') - first);
            } else if (begins(line, "  ")) {
                all.push_back(parse_key(section, line));
            }
        }
    }
    return all;
}

const Key *key_of(const std::string &path)
{
    static std::map<std::string, const Key *> all;
    if (all.empty()) {
        for (const Key &key : keys()) {
            all[key.path()] = &key;
            if (!key.si_name.empty()) {
                all[key.section + "." + key.si_name] = &key;
            }
        }
    }
    auto found = all.find(path);
    return found == all.end() ? NULL : found->second;
}

/* "bias_rad_s" beside "bias_deg_h" ends with "rad/s". */
std::string Key::si_unit() const
{
    size_t same = 0;
    while (same < name.size() && same < si_name.size() && name[same] == si_name[same]) {
        same++;
    }
    if (same == 0 || same == si_name.size()) {
        return same == 0 ? "SI" : "1";
    }
    size_t end = si_name.rfind('_', same + 1);
    std::string unit = si_name.substr(end == std::string::npos || end + 1 < same ? same : end + 1);
    const std::pair<const char *, const char *> words[] = {
        {"sqrt_s", "sqrt(s)"}, {"_per_", " / "}, {"_", "/"}};
    for (const auto &word : words) {
        for (size_t at; (at = unit.find(word.first)) != std::string::npos;) {
            unit.replace(at, strlen(word.first), word.second);
        }
    }
    return unit;
}

bool Key::single_sets(size_t element) const
{
    return count < 9 || (takes.find("off the diagonal") != std::string::npos) == (element % 4 != 0);
}

/* A scene that sets one key, for what the library says of it: the range of a value, or the value in the key's
 * unit. */
static std::string scene_with(const Key &key, const std::string &name, const std::string &value)
{
    std::string numbers = value, manoeuvre = "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n";
    for (size_t k = 1; k < key.count; k++) {
        numbers += ", 0";
    }
    std::string line = name + " = " + (key.count > 1 ? "[" + numbers + "]" : numbers) + "\n";
    return key.section == "manoeuvre" ? "[flight]\n" + manoeuvre + line
           : key.section == "flight"  ? "[flight]\n" + line + manoeuvre
                                      : "[flight]\n[" + key.section + "]\n" + line + manoeuvre;
}

double Key::units_per_si() const
{
    Scene scene;
    double units = 1;
    if (unit == "deg") {
        return 1 / SINS_DEG; /* angles of manoeuvres do not stand alone */
    }
    scene.read(scene_with(*this, si_name, "1"));
    for (const Item &item : scene.items()) {
        for (const auto &entry : item.entries) {
            if (item.section == section && entry.first == name) {
                number_of(numbers(entry.second, *this)[0], units);
            }
        }
    }
    return units;
}

std::wstring Key::tip() const
{
    static std::map<std::string, std::string> ranges;
    if (count > 0 && ranges.count(path()) == 0) {
        std::string &range = ranges[path()];
        for (const Fault &fault : Scene().read(scene_with(*this, name, PROBE))) {
            size_t from = fault.sentence.rfind("from ");
            if (range.empty() && from != std::string::npos &&
                fault.sentence.find(name) != std::string::npos) {
                range = fault.sentence.substr(from);
            }
        }
    }
    std::wstring range = wide(ranges[path()]);
    return label(path(), doc) + (unit.empty() ? L"" : L" [" + wide(unit) + L"]") +
           (range.empty() ? L"" : L"\n" + range);
}

Texts Key::word_labels() const
{
    Texts labels;
    for (const std::string &word : words) {
        labels.push_back(word_label(word));
    }
    return labels;
}

size_t Key::index_of(const std::string &value) const
{
    auto found = std::find(words.begin(), words.end(), unquoted(value));
    return found == words.end() ? 0 : (size_t)(found - words.begin());
}

std::string Item::get(const Key &key) const
{
    for (const auto &entry : entries) {
        if (entry.first == key.name) {
            return entry.second;
        }
        if (entry.first == key.si_name) { /* no number in the key's unit is the same to the bit */
            std::vector<std::string> elements = numbers(entry.second, key);
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
    auto is_own = [&](const std::pair<std::string, std::string> &entry) {
        return entry.first == key.name || entry.first == key.si_name;
    };
    entries.erase(std::remove_if(entries.begin(), entries.end(), is_own), entries.end());
    if (!value.empty()) {
        entries.push_back({in_si ? key.si_name : key.name, value});
    }
}

Texts Item::described() const
{
    std::wstring words, values;
    for (const auto &entry : entries) {
        const Key &key = *key_of(section + "." + entry.first);
        if (!key.words.empty()) {
            words += (words.empty() ? L"" : L" ") + key.word_label(unquoted(entry.second));
        } else {
            values += (values.empty() ? L"" : L", ") + label(key.path() + ".short", entry.first) + L" " +
                      wide(get(key)) + (key.unit.empty() ? L"" : L" " + wide(key.unit));
        }
    }
    return {words, values};
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

/* A whole number of up to 64 bits must not go through a double. */
static bool is_whole(const std::string &text)
{
    return text.find_first_not_of("0123456789") == std::string::npos && text.size() < 20 &&
           (text.size() == 1 || text[0] != '0');
}

std::string toml(const std::wstring &typed)
{
    std::string text = narrow(typed);
    double number;
    size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
    return is_whole(text) ? text : number_of(text, number) ? shortest(number) : quoted(text);
}

std::vector<std::string> numbers(const std::string &value, const Key &key)
{
    std::vector<std::string> result;
    bool is_list = begins(value, "[");
    std::vector<std::string> list =
        is_list ? split(value.substr(1, value.size() - 2), ", ") : std::vector<std::string>();
    for (size_t k = 0; k < key.count; k++) {
        std::string element = is_list ? (k < list.size() ? list[k] : "") : key.single_sets(k) ? value : "";
        result.push_back(is_list && (element == "0" || element == "0.0") ? "" : element);
    }
    return result;
}

std::string list_of(const std::vector<std::string> &numbers)
{
    std::string list;
    bool is_off = true;
    for (const std::string &number : numbers) {
        is_off = is_off && number.empty();
        list += (list.empty() ? "" : ", ") + (number.empty() ? "0" : number);
    }
    return is_off ? "" : "[" + list + "]";
}
