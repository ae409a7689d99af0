/* The exchange between the controls of a dialog and the keys of a scene, as DoDataExchange() of MFC: one table a dialog. */
#pragma once
#include <functional>

#include "dialog.h"
#include "scene.h"

/* An edit field, a combo box of words, or a check box; of a key of several numbers the control of one of them. */
struct Field {
    int id;
    std::string path;
    int element; /* 0 where the key has one value */
};

/* What a user typed as a value of TOML: anything but a number in quotes, so that the library says what it expected. */
std::string toml(const std::wstring &typed);

class ExchangeDialog : public Dialog {
protected:
    /* Tells which controls show which keys, fills combo boxes with the words, and gives tool tips. */
    void exchange(const std::vector<Field> &fields);
    /* From keys to controls. What a user typed wrong stays while it is marked, unless all is new. */
    void load(const std::function<std::string(const std::string &path)> &value, bool all_is_new);
    /* What the user changed since the load. */
    std::vector<Change> changes() const;
    /* Marks the fields at fault; the sentence of the first, "" if there is none. */
    std::wstring mark_faults(const std::vector<Fault> &faults);
    /* Whether this notification says that a field has a new value. */
    bool is_change(int id, int code) const;

    /* The key whose fields are in SI units now; "": none. */
    std::string si_path_;

private:
    std::vector<Field> fields_;
    std::map<int, std::string> loaded_;      /* by control: the whole value, of which the control shows 15 digits */
    std::map<int, std::wstring> shown_;
    std::wstring text_of(const Field &field) const;
    std::string value_of(const Field &field) const;
};
