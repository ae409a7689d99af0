// The scene of the page: its values by their paths, such as "gyro.bias_deg_h" and "manoeuvre[3].bank_deg", and its faults. Every list of
// keys, words, units and limits is the library's.

import { all_of, items_of } from "./flight.mjs";
import { label, shown, text, told } from "./texts.mjs";

export class Scene extends EventTarget {
    constructor(sins) {
        super();
        this.sins = sins;
        this.keys = [];
        const key = new sins.scene_key();
        do {
            sins.scene_get_key(this.keys.length, key);
            this.keys.push({ ...key.copy(), path: `${key.section}.${key.name}` });
        } while (this.keys.length < Number(key.count));
        this.by_path = new Map(this.keys.map((own) => [own.path, own]));
        this.by_si = new Map(this.keys.filter((own) => own.si_name).map((own) => [`${own.section}.${own.si_name}`, own]));
        [this.faults, this.refused] = [[], []];
        this.open(sins.scene_create_builtin("simulation2"));
    }

    /** The names of the built-in scenes. */
    builtins() {
        return all_of((k) => this.sins.scene_builtin_name(k));
    }

    /** The names of the files beside the log of the scene. */
    beside() {
        return all_of((k) => this.sins.scene_log_file_name(this.handle, k));
    }

    /** The key of a path, which may have places in lists. */
    key(path) {
        return this.by_path.get(path.replace(/\[\d+\]/g, ""));
    }

    meaning(path) {
        const key = this.key(path ?? "");
        return key && label(key.path, key.meaning);
    }

    /** The name of a key beside its field: in English the words of the key without its unit, otherwise its meaning up to the first mark. */
    name(path) {
        const key = this.key(path), told = label(key.path, ""), plain = key.name.replace(UNIT, "");
        if (told) return told.split(/[；，：（]/)[0];
        // A key alignment_s beside one alignment is its time.
        const time = plain !== key.name && this.by_path.has(`${key.section}.${plain}`) ? " time" : "";
        return plain.replaceAll("_", " ").replace(/(?<=g|temperature)2/, "²") + time;
    }

    /** The sentence of a fault in the language of the user. */
    told(fault) {
        return told(this.on_page(fault), (path) => this.meaning(path), this.sins);
    }

    /** A fault as one of the field on the page: with its key, and its numbers in its unit. Errors of the library are in SI. */
    on_page(fault) {
        const { path = "", sentence = "", flags = 0, minimum, maximum } = fault, plain = path.replace(/\[\d+\]/g, "");
        const of_si = this.by_si.get(plain), key = of_si ?? this.by_path.get(plain), size = of_si?.si_per_unit ?? 1;
        if (fault.unit !== undefined || !key?.unit) return fault;
        const { ERROR_INFO_MINIMUM, ERROR_INFO_MAXIMUM } = this.sins, unit = unit_name(key);
        const limits = [[ERROR_INFO_MINIMUM, minimum], [ERROR_INFO_MAXIMUM, maximum]].filter(([flag]) => flags & flag).map(([, limit]) => limit);
        const in_unit = (written) => (of_si && Number.isFinite(Number(written)) ? shown(Number(written) / size, 6) : written);
        const [, name = "", value = "", rule = sentence] = /^(\S+) = (\S+): (.*)$/s.exec(sentence) ?? [];
        const is_limit = ([written]) => limits.some((limit) => Math.abs(Number(written) - limit) <= 1e-5 * Math.abs(limit));
        const numbers = [...rule.matchAll(/(?<![\w.[])-?\d[\d.]*(?:e-?\d+)?(?!\w)/g)].filter(is_limit);
        const parts = numbers.map((own, k) => {
            const begin = k === 0 ? 0 : numbers[k - 1].index + numbers[k - 1][0].length;
            return rule.slice(begin, own.index) + in_unit(own[0]);
        });
        const end = numbers.length ? ` ${unit}${rule.slice(numbers.at(-1).index + numbers.at(-1)[0].length)}` : rule;
        const head = name && `${of_si ? name.replace(path, key.path) : name} = ${in_unit(value)}: `;
        const own = { value: fault.value / size, minimum: minimum / size, maximum: maximum / size, unit };
        return { ...fault, ...own, path: of_si ? key.path : path, sentence: head + parts.join("") + end };
    }

    /** Marks the field of a fault that is found only with the samples of the flight, until the scene changes; null: there is none. */
    refuse(fault) {
        const found = fault && this.on_page(fault), before = this.refused.length;
        this.refused = found && this.key(found.path ?? "") ? [{ ...found, in_text: true }] : [];
        if (before + this.refused.length) this.dispatchEvent(new Event("refused"));
    }

    /** What the library says of an error that was thrown. */
    told_error(error) {
        const info = error.info?.copy?.();
        return this.told({ sentence: error.message, path: info?.field, ...info });
    }

    /** Whether a value of a key is that which it has without a line. */
    is_default(key, value = this.get(key.path)) {
        return ["", unquoted(key.default_value)].includes(value) || (key.elements > 1 && value === "0");
    }

    /** Meaning, unit and range of a key. */
    hint(key) {
        const { LIMITS, ZERO } = { LIMITS: this.sins.SCENE_KEY_LIMITS, ZERO: this.sins.SCENE_KEY_ZERO_IS_OFF };
        const range = key.flags & ZERO ? "range_or_0" : "range";
        const limits = key.flags & LIMITS ? text(range, shown(key.minimum, 6), shown(key.maximum, 6)) : "";
        const many = key.elements === 3 ? text("three_numbers") : key.elements === 9 ? text("nine_numbers") : "";
        const meaning = this.meaning(key.path), is_told = meaning === this.name(key.path);
        return [!is_told && meaning, limits + (limits && key.unit ? ` ${unit_name(key)}` : ""), many, key.default_value && text("default_is", key.default_value)]
            .filter(Boolean)
            .join("; ");
    }

    /** The words that a key takes, or null. */
    words(key) {
        const { SCENE_KEY_WORD, SCENE_KEY_FLAG } = this.sins;
        return key.kind === SCENE_KEY_WORD ? key.words.split("|") : key.kind === SCENE_KEY_FLAG ? ["false", "true"] : null;
    }

    word_label(key, word) {
        return label(`${key.path}.${word}`, key.name === "preset" ? label(`preset.${word}`, word) : word.replaceAll("_", " "));
    }

    open(handle) {
        this.handle?.close();
        this.handle = handle;
        this.titled = { title: this.get("flight.title"), what: what_flies(this.text) };
        this.told_of_change([], "opened");
    }

    /** What the scene calls itself, unless it is no longer the scene that was opened under that title. */
    get title() {
        const title = this.get("flight.title");
        return title === this.titled.title && this.titled.what.some((line) => !what_flies(this.text).includes(line)) ? "" : title;
    }

    told_of_change(faults, source = null) {
        [this.faults, this.refused] = [faults, []];
        this.dispatchEvent(Object.assign(new Event("change"), { source }));
    }

    /** Whether the flight is a log. */
    get is_log() {
        return this.sins.scene_get_setup(this.handle).flight === this.sins.SCENE_FLIGHT_LOG;
    }

    /** Its text as the library writes it. */
    get text() {
        return this.sins.scene_write(this.handle);
    }

    /** Takes a text, if it has no faults. */
    parse(written) {
        const { sins } = this;
        const found = sins.scene_parse(written);
        if (sins.last_status === sins.SCENE_HAS_FAULTS) {
            this.told_of_change(this.read_faults(found).map((fault) => ({ ...fault, in_text: true })), "text");
            found.close();
            return false;
        }
        this.handle.close();
        this.handle = found;
        this.told_of_change([], "text");
        return true;
    }

    read_faults(handle) {
        const fault = new this.sins.fault(), faults = [];
        try {
            do {
                this.sins.scene_get_fault(handle, faults.length, fault);
                faults.push(fault.copy());
            } while (faults.length < Number(fault.count));
        } catch {
            // none
        }
        return faults;
    }

    /** The value at a path without the quotes of words and texts, or "". */
    get(path) {
        try {
            return unquoted(this.sins.scene_get_value(this.handle, path));
        } catch {
            return "";
        }
    }

    /** Sets values, all or none. Returns the faults. */
    set(changes) {
        const lines = Object.entries(changes).map(([path, value]) => `${path} = ${this.written(path, value)}\n`);
        return this.change(() => this.sins.scene_set_values(this.handle, lines.join("")), Object.keys(changes));
    }

    /** A value as the library reads it: several numbers stand in brackets. */
    written(path, value) {
        const key = this.key(path), several = value.trim().split(/[\s,;]+/);
        const is_list = key?.elements > 1 && !/\[\d\]$/.test(path) && several.length > 1 && !value.includes("[");
        return (is_list ? `[${several.join(", ")}]` : value).replaceAll("\n", " ");
    }

    /** The items of a list, "manoeuvre", "failure", "update" or "panel", as texts. */
    items(list) {
        return items_of(this.sins, this.handle, list);
    }

    set_items(list, items) {
        return this.change(() => this.sins.scene_set_items(this.handle, list, items.join("\n")), [list]);
    }

    change(call, paths) {
        // Faults of other fields stay: their texts are still in the form.
        const others = this.faults.filter((fault) => !fault.in_text && !paths.some((path) => fault.path.startsWith(path)));
        let faults = [];
        try {
            call();
        } catch (error) {
            faults = error.status === this.sins.ERROR_INVALID_ARGUMENT ? this.read_faults(this.handle) : [];
            if (faults.length === 0) faults = [{ path: paths[0], sentence: error.message }];
        }
        this.told_of_change([...others, ...faults]);
        return faults;
    }
}

/** The lines of which a title may speak: all but options, output and rate; and the number of manoeuvres. */
const what_flies = (written) => [...written.replace(/^\[(options|output)\]\n(.+\n)*|^rate_hz = .*\n/gm, "").split("\n"), written.split("[[man").length];

/** The unit at the end of the name of a key. */
const UNIT = /(_(deg|h2?|s2?|m|mm|km|g2?|k2?|c|hz|ppm|per|sqrt|micro|arcsec|arcmin|mgal|kt))+$/;
export const unit_name = (key) => key.unit.replace("deg C", "°C").replaceAll("deg", "°").replace("micro-g", "µg").replace("sqrt", "√").replace(/2$/, "²");

export function unquoted(value) {
    return /^".*"$/s.test(value) ? value.slice(1, -1).replace(/\\(.)/g, "$1") : value;
}

export function quoted(value) {
    return `"${value.replace(/["\\]/g, "\\$&")}"`;
}
