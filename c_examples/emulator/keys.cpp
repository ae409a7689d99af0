/* The keys of a scene, as the library tells them. */
#include <map>

#include "scene.h"

/* A number beyond every limit, to be told the limit. */
static const char PROBE[] = "1e17";

/* "doc; what it takes [unit]; in SI name": the doc may have semicolons of its own. */
static Key parse_key(const std::string &section, const std::string &line)
{
    Key key = {};
    size_t colon = line.find(": "), in_si = line.rfind("; in SI "), takes;
    std::string rest = line.substr(colon + 2, in_si == std::string::npos ? in_si : in_si - colon - 2);
    key.section = section;
    key.name = line.substr(2, colon - 2);
    key.si_name = in_si == std::string::npos ? "" : line.substr(in_si + 8);
    takes = rest.rfind("; ");
    key.doc = rest.substr(0, takes);
    key.takes = takes == std::string::npos ? "" : rest.substr(takes + 2);
    size_t unit = key.takes.rfind(" [");
    if (unit != std::string::npos) {
        key.unit = key.takes.substr(unit + 2, key.takes.size() - unit - 3);
    }
    if (key.takes.find('|') != std::string::npos) {
        key.words = split(key.takes, "|");
    } else if (key.takes == "true or false") {
        key.words = {"false", "true"};
    } else if (begins(key.takes, "a text")) {
        key.is_text = true;
    } else {
        key.count = key.takes.find("nine") != std::string::npos ? 9 : key.takes.find("three") != std::string::npos ? 3 : 1;
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
    for (const Key &key : keys()) {
        if (key.path() == path || (!key.si_name.empty() && key.section + "." + key.si_name == path)) {
            return &key;
        }
    }
    return NULL;
}

/* "bias_rad_s" beside "bias_deg_h" ends with "rad/s". */
std::string Key::si_unit() const
{
    size_t same = 0, end;
    while (same < name.size() && same < si_name.size() && name[same] == si_name[same]) {
        same++;
    }
    end = si_name.rfind('_', same == si_name.size() ? same : same + 1);
    std::string unit = same == si_name.size() ? "1" : end == std::string::npos || end + 1 < same ? si_name.substr(same) : si_name.substr(end + 1);
    for (const auto &pair : {std::make_pair(std::string("sqrt_s"), "sqrt(s)"), std::make_pair(std::string("_per_"), " / ")}) {
        size_t at = unit.find(pair.first);
        if (at != std::string::npos) {
            unit.replace(at, pair.first.size(), pair.second);
        }
    }
    for (char &letter : unit) {
        letter = letter == '_' ? '/' : letter;
    }
    return same == 0 ? "SI" : unit;
}

bool Key::single_sets(int element) const
{
    return count < 9 || (takes.find("off the diagonal") != std::string::npos) == (element % 4 != 0);
}

/* A scene that sets one key, for what the library says of it: the range of a value, or the value in the key's own unit. */
static std::string scene_with(const Key &key, const std::string &name, const std::string &value)
{
    std::string numbers = value, line, manoeuvre = "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n";
    for (int k = 1; k < key.count; k++) {
        numbers += ", 0";
    }
    line = name + " = " + (key.count > 1 ? "[" + numbers + "]" : numbers) + "\n";
    return key.section == "manoeuvre" ? "[flight]\n" + manoeuvre + line
           : key.section == "flight"  ? "[flight]\n" + line + manoeuvre
                                      : "[flight]\n[" + key.section + "]\n" + line + manoeuvre;
}

double Key::units_per_si() const
{
    Scene scene;
    std::vector<Fault> faults;
    double units = 1;
    if (unit == "deg") {
        return 1 / SINS_DEG; /* angles of manoeuvres do not stand alone */
    }
    if (!si_name.empty() && scene.read(scene_with(*this, si_name, "1"), faults)) {
        for (const Item &item : scene.items()) {
            for (const auto &entry : item.entries) {
                if (item.section == section && entry.first == name) {
                    number_of(numbers(entry.second, *this)[0], units);
                }
            }
        }
    }
    return units;
}

std::wstring tip_of(const Key &key)
{
    static std::map<std::string, std::wstring> ranges;
    std::wstring tip = label(key.path(), key.doc) + (key.unit.empty() ? L"" : L" [" + wide(key.unit) + L"]");
    if (key.count > 0 && ranges.count(key.path()) == 0) {
        std::vector<Fault> faults;
        Scene().read(scene_with(key, key.name, PROBE), faults);
        std::wstring &range = ranges[key.path()];
        for (const Fault &fault : faults) {
            size_t from = fault.sentence.rfind("from ");
            if (range.empty() && from != std::string::npos && fault.sentence.find(key.name) != std::string::npos) {
                range = L"\n" + wide(fault.sentence.substr(from));
            }
        }
    }
    return tip + ranges[key.path()];
}
