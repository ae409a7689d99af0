#include "keys.h"

#include <map>
#include <regex>

#include "scene.h"

/* "  name: doc; what it takes [unit]; in SI name": the doc may have semicolons of its own. */
static Key parse_key(const std::string &section, const std::string &line)
{
    static const std::regex LINE("  (\\w+): (.*?)(; in SI (\\w+))?"), DOC("(.*); (.*?( \\[(.*)\\])?)");
    std::smatch found, inner;
    Key key = {};
    std::regex_match(line, found, LINE);
    std::string doc = found[2];
    key.section = section;
    key.name = found[1];
    key.path = section + "." + key.name;
    key.si_name = found[4];
    bool has_takes = std::regex_match(doc, inner, DOC);
    key.doc = has_takes ? inner[1].str() : doc;
    key.takes = inner[2];
    key.unit = inner[4];
    if (key.takes.find('|') != std::string::npos) {
        key.words = split(key.takes, "|");
    } else if (key.takes == "true or false") {
        key.words = {"false", "true"};
    } else if (!key.takes.starts_with("a text")) {
        bool is_matrix = key.takes.find("nine") != std::string::npos;
        key.count = is_matrix ? 9 : key.takes.find("three") != std::string::npos ? 3 : 1;
    }
    return key;
}

const std::vector<Key> &keys()
{
    static std::vector<Key> all;
    std::string section;
    for (const std::string &line : split(all.empty() ? whole_text(lib.sins_scene_write_keys) : "", "\n")) {
        if (line.starts_with("[")) {
            size_t first = line.find_first_not_of('[');
            section = line.substr(first, line.find(']') - first);
        } else if (line.starts_with("  ")) {
            all.push_back(parse_key(section, line));
        }
    }
    return all;
}

const Key *key_of(const std::string &path)
{
    static std::map<std::string, const Key *> all;
    if (all.empty()) {
        for (const Key &key : keys()) {
            all[key.section + "." + key.si_name] = &key;
            all[key.path] = &key;
        }
    }
    auto found = all.find(path);
    return found == all.end() ? NULL : found->second;
}

/* "bias_rad_s" beside "bias_deg_h" ends with "rad/s": the words in which they differ. */
std::wstring Key::si_unit() const
{
    size_t same =
        std::mismatch(name.begin(), name.end(), si_name.begin(), si_name.end()).first - name.begin();
    if (same == 0 || (same == si_name.size() && name[same] == '_')) {
        return same == 0 ? L"SI" : L"1";
    }
    std::string unit = si_name.substr(si_name.rfind('_', same - 1) + 1);
    for (auto [from, to] :
         {std::pair("^enu_", ""), {"sqrt_s", "sqrt(s)"}, {"^per_", "1 / "}, {"_per_", " / "}, {"_", "/"}}) {
        unit = std::regex_replace(unit, std::regex(from), to);
    }
    return wide(unit);
}

bool Key::single_sets(size_t element) const
{
    return count < 9 || (takes.find("off the diagonal") != std::string::npos) == (element % 4 != 0);
}

/* A scene that sets one key, for what the library says of it: the range of a value, or the value in the key's
 * unit. */
static Items scene_with(const Key &key, const std::string &name, const std::string &value)
{
    Items items = {{"flight", {}, {}}, {"manoeuvre", {{"kind", "\"rest\""}, {"duration_s", "1"}}, {}}};
    Item *own = key.section == "flight" ? &items[0] : key.section == "manoeuvre" ? &items[1] : NULL;
    own = own != NULL ? own : &*items.insert(items.begin() + 1, {key.section, {}, {}});
    std::vector<std::string> elements(key.count, "0");
    elements[0] = value;
    own->entries.push_back({name, key.count > 1 ? list_of(elements) : value});
    return items;
}

double Key::units_per_si() const
{
    Scene scene;
    double units = 1 / SINS_DEG; /* angles of manoeuvres do not stand alone */
    if (unit != "deg") {
        scene.read(scene_with(*this, si_name, "1"));
        number_of(numbers(scene.get(path), *this)[0], units);
    }
    return units;
}

std::wstring Key::tip() const
{
    static std::map<std::string, std::wstring> ranges;
    if (count > 0 && ranges.count(path) == 0) {
        ranges[path] = L"";
        for (const Fault &fault : Scene().read(scene_with(*this, name, "1e17"))) { /* beyond every limit */
            size_t from = fault.sentence.rfind("from ");
            if (from != std::string::npos && fault.sentence.find(name) != std::string::npos) {
                ranges[path] = L"\n" + wide(fault.sentence.substr(from));
            }
        }
    }
    return label(path, doc) + (unit.empty() ? L"" : L" [" + wide(unit) + L"]") + ranges[path];
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
    size_t index = std::find(words.begin(), words.end(), unquoted(value)) - words.begin();
    return index < words.size() ? index : 0;
}

std::string in_quotes(const std::string &text)
{
    return "\"" + std::regex_replace(text, std::regex("[\"\\\\]"), "\\$&") + "\"";
}

std::string unquoted(const std::string &value)
{
    bool is_quoted = value.size() > 1 && value[0] == '"';
    return is_quoted ? std::regex_replace(value.substr(1, value.size() - 2), std::regex("\\\\(.)"), "$1")
                     : value;
}

std::string toml(const std::wstring &typed)
{
    static const std::regex WHOLE("(0|[1-9]\\d{0,18})?");
    std::string text = narrow(typed);
    double number;
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    if (std::regex_match(text, WHOLE)) { /* one of up to 64 bits must not go through a double */
        return text;
    }
    return number_of(text, number) ? shortest(number) : in_quotes(text);
}

std::vector<std::string> numbers(const std::string &value, const Key &key)
{
    std::vector<std::string> result(key.count, value);
    bool is_list = value.starts_with("[");
    std::vector<std::string> list = is_list ? split(value.substr(1, value.size() - 2), ", ") : result;
    list.resize(key.count);
    for (size_t k = 0; k < key.count; k++) {
        bool is_zero = is_list ? list[k] == "0" || list[k] == "0.0" : !key.single_sets(k);
        result[k] = is_zero ? "" : list[k];
    }
    return result;
}

std::string list_of(const std::vector<std::string> &numbers)
{
    std::string list;
    for (const std::string &number : numbers) {
        list += (list.empty() ? "[" : ", ") + (number.empty() ? "0" : number);
    }
    bool is_off = std::all_of(numbers.begin(), numbers.end(), [](auto &number) { return number.empty(); });
    return is_off ? "" : list + "]";
}
