// Texts in the language of the user: those of SINS_Emulator. en.txt and zh.txt have lines "name = text"; without a line, the English text
// is the name.

export let language = "en";
const tables = {};

/** A text of a dialog without the letter of its key: "L&atitude [°]" and "纬度 [°](&A)". */
const plain = (text) => text.replace(/\(&.\)/, "").replaceAll("&", "").replace(/\.\.\.$|……$/, "");

export function read_texts(files) {
    for (const [name, lines] of Object.entries(files)) {
        const rows = lines.split("\n").filter((line) => line.includes(" = "));
        tables[name] = new Map(rows.map((line) => line.split(/ = (.*)/s)).map(([own, text]) => [plain(own), plain(text)]));
    }
}

export function speak(wanted) {
    language = wanted === "zh" ? "zh" : "en";
}

/** The language of the last visit, or null: a page of a file may have no memory. */
export function stored_language() {
    try {
        return localStorage.getItem("sins_language");
    } catch {
        return null;
    }
}

export function remember_language() {
    try {
        localStorage.setItem("sins_language", language);
    } catch {
        // no memory
    }
}

/** A text by its name, with values for %1, %2, ... */
export function text(name, ...values) {
    const found = tables[language].get(name) ?? name;
    return values.reduce((all, value, k) => all.replace(`%${k + 1}`, value), found);
}

/** A name of the library: the label of the table, or otherwise what the library says. */
export const label = (name, otherwise) => tables[language].get(name) ?? otherwise;

/** The part of a text that is a list. */
export const parts = (name) => text(name).split(";");

/** A number with so many significant digits, as short as it may be. */
export const shown = (value, digits) => (Number.isFinite(value) ? String(Number(value.toPrecision(digits))) : "-");

/**
 * What the library says of a fault or an error in the language of the user. With limits, it is made of the name, the value and the limits;
 * otherwise a rule of the table translates it: what follows "gyro.bias_deg_h[1] = -3: ".
 */
export function told({ sentence, path, flags = 0, value, minimum, maximum, unit }, name_of, info_flags) {
    const limits = info_flags.ERROR_INFO_MINIMUM | info_flags.ERROR_INFO_MAXIMUM;
    if (language === "en") {
        return sentence;
    }
    const name = [name_of(path), path].filter(Boolean).join(" ");
    if ((flags & limits) === limits) {
        const kind = flags & info_flags.ERROR_INFO_VALUE ? "limits" : "expected";
        return text(kind, name, shown(value, 6), shown(minimum, 6), [shown(maximum, 6), unit].filter(Boolean).join(" "));
    }
    const end = sentence.slice(sentence.indexOf(": ") + 2);
    for (const [rule, translation] of tables[language]) {
        const pattern = rule.startsWith("rule ") ? new RegExp(`^(?:${rule.slice(5)})$`) : null;
        if (pattern?.test(end)) {
            return `${name}：${end.replace(pattern, translation)}`;
        }
    }
    return sentence;
}

/** An element of the page: its attributes, handlers of events (onclick), and children. */
export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on") || name === "value" || name === "disabled" || name === "hidden" || name === "textContent") {
            made[name] = value;
        } else if (value !== undefined) {
            made.setAttribute(name, value);
        }
    }
    made.append(...children);
    return made;
}

/** Choices of a list: [value, text]. */
export const options = (choices, chosen) =>
    choices.map(([value, shown_text]) => {
        const option = element("option", { value }, shown_text);
        option.selected = value === chosen;
        return option;
    });
