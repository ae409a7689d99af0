/*
 * sins.h for JavaScript: the library as WebAssembly, in Node, in pages and in their workers.
 *
 *     import { load } from "sins";
 *
 *     const sins = await load();
 *     const sim = sins.create(null);                                    // destroyed when it is dropped, or by sim.close()
 *     const gyro = new sins.gyro_params({ bias_rad_s: [0.01 * sins.DEG_PER_HOUR, 0, 0] });   // other fields are 0: off
 *     sins.set_gyro(sim, gyro);
 *     const sample = new sins.flight_sample({ latitude_rad: 39.9 * sins.DEG });
 *     for (sample.time_s = 0; sample.time_s <= 3600; sample.time_s++) {
 *         sins.push_sample(sim, sample);
 *         sins.step(sim);
 *     }
 *     const errors = sins.get_errors(sim, sins.ERRORS_NAVIGATION);
 *     console.log(errors.position_enu_m[0], errors.position_enu_m[1]);
 *
 * sins_create() of the header is sins.create() here, and SINS_DEG is sins.DEG: names, arguments and their order are those of the
 * header, but without the length after an array. NULL is null. Handles and numbers that a call writes are no arguments: the call
 * returns them instead of its status. Structs at the end of the arguments that a call writes may be left out: then the call makes and
 * returns them too. A call that returns several things returns an array, and null if there is none yet (sins.NEED_SAMPLE). A text that
 * a call writes is returned. A status below 0 is thrown as SinsError; sins.last_status is the status of the last call.
 *
 * Structs are memory of the library, and their arrays of numbers are views of it, without copies: Float64Array. Arrays for a call are
 * sins.array(sins.record, 1000), sins.numbers(6), sins.bytes(size); arrays that the library only reads may also be arrays of
 * JavaScript. The memory may move when something is created: a view is empty then. Take it again from its struct. Whole numbers of
 * 64 bits are bigint; a number may be assigned to them.
 *
 * This file is written by build/ from the Rust sources; do not edit it.
 */

/** A call that failed: its status, the library's sentence, and in info what the sentence is made of. */
export class SinsError extends Error {
    constructor(status, sentence, info = null) {
        super(sentence);
        this.name = "SinsError";
        this.status = status;
        this.info = info;
    }
}

/**
 * Loads the library: sins.wasm beside this file, or what source is: an address, bytes, a Response, or a WebAssembly.Module. Each call
 * makes an instance with memory of its own.
 */
export async function load(source = new URL("sins.wasm", import.meta.url)) {
    return bind((await WebAssembly.instantiate(await compiled(source), {})).exports);
}

async function compiled(source) {
    if (source instanceof WebAssembly.Module) {
        return source;
    }
    if (typeof source === "string" || source instanceof URL) {
        const url = new URL(source, import.meta.url);
        if (url.protocol === "file:" && typeof process === "object") {
            source = await (await import("node:fs/promises")).readFile(url);
        } else {
            source = await fetch(url);
            if (!source.ok) {
                throw new Error(`the library sins cannot be loaded: ${url}: ${source.status} ${source.statusText}`);
            }
        }
    }
    return WebAssembly.compile(typeof Response === "function" && source instanceof Response ? await source.arrayBuffer() : source);
}

const CONSTANTS = {
    // <constants>
};
const { ERROR_BUFFER_TOO_SMALL, ERROR_INTERNAL, ERROR_OUT_OF_MEMORY, NEED_SAMPLE } = CONSTANTS;

const AT = Symbol("address"), OWNER = Symbol("owner"), KEY = Symbol("key");
/** Memory that every call may use for numbers that it writes, and for texts. */
const OUT_SIZE = 64, TEXT_SIZE = 16384;
const UTF8 = new TextEncoder(), TEXT = new TextDecoder();

/** The library of the exports of its module. */
function bind(wasm) {
    let F64, I32, U32, U8, I64, U64;
    let last_status = 0;

    function look() {
        const { buffer } = wasm.memory;
        [F64, I32, U32, U8] = [new Float64Array(buffer), new Int32Array(buffer), new Uint32Array(buffer), new Uint8Array(buffer)];
        [I64, U64] = [new BigInt64Array(buffer), new BigUint64Array(buffer)];
    }
    // When the memory grows, views of it become empty.
    const views = {
        f8: () => (F64.length === 0 && look(), F64),
        i4: () => (F64.length === 0 && look(), I32),
        u4: () => (F64.length === 0 && look(), U32),
        c1: () => (F64.length === 0 && look(), U8),
        i8: () => (F64.length === 0 && look(), I64),
        u8: () => (F64.length === 0 && look(), U64),
    };
    const SHIFT = { f8: 3, i4: 2, u4: 2, c1: 0, i8: 3, u8: 3 };
    look();

    let has_ended = false;
    const dropped_memory = new FinalizationRegistry(({ at, size }) => has_ended || wasm.sins_wasm_free(at, size));
    const dropped_handles = new FinalizationRegistry(({ destroy, key }) => has_ended || wasm[destroy](key));

    function allocate(size) {
        const at = wasm.sins_wasm_allocate(size) >>> 0;
        if (at === 0) {
            throw new SinsError(ERROR_OUT_OF_MEMORY, `not enough memory for ${size} bytes`);
        }
        return at;
    }

    /** Memory of an object, freed when the object is dropped. */
    function own_memory(object, size) {
        object[AT] = allocate(Math.max(size, 8));
        dropped_memory.register(object, { at: object[AT], size: Math.max(size, 8) });
        return object;
    }

    const wrong = (name, value, rule) => new TypeError(`${name} = ${typeof value === "bigint" ? value : shown(value)}: ${rule}`);
    const shown = (value) => (typeof value === "string" ? JSON.stringify(value) : String(value?.constructor?.name === "Object" ? "{...}" : value));

    /** A view of memory that lives as long as the view. */
    const owners = new WeakMap();
    const kept = (view, owner) => (owners.set(view, owner), view);

    /** What a number of each kind may be. */
    function whole(least, most) {
        return (value, name) => {
            if (!Number.isInteger(value) || value < least || value > most) {
                throw wrong(name, value, `must be a whole number from ${least} to ${most}`);
            }
            return value;
        };
    }
    function big(least, most) {
        return (value, name) => {
            const number = typeof value === "number" && Number.isInteger(value) ? BigInt(value) : value;
            if (typeof number !== "bigint" || number < least || number > most) {
                throw wrong(name, value, `must be a whole number from ${least} to ${most}`);
            }
            return number;
        };
    }
    const checks = {
        f8(value, name) {
            if (typeof value !== "number") {
                throw wrong(name, value, "must be a number");
            }
            return value;
        },
        i4: whole(-(2 ** 31), 2 ** 31 - 1),
        u4: whole(0, 2 ** 32 - 1),
        i8: big(-(2n ** 63n), 2n ** 63n - 1n),
        u8: big(0n, 2n ** 64n - 1n),
    };
    const { f8: as_f8, i4: as_i4, u4: as_u4, u8: as_u8 } = checks;

    function text_at(at, most) {
        const bytes = views.c1();
        let end = at;
        while (end < at + most && bytes[end] !== 0) {
            end++;
        }
        return TEXT.decode(bytes.subarray(at, end));
    }

    /** How a field is read and set. */
    function field(path, kind, offset, count) {
        const view = views[kind], shift = SHIFT[kind], check = checks[kind];
        if (kind === "c1") {
            return {
                get() { return text_at(this[AT] + offset, count); },
                set(value) {
                    const bytes = typeof value === "string" && !value.includes("\0") ? UTF8.encode(value) : null;
                    if (bytes === null || bytes.length >= count) {
                        throw wrong(path, value, `must be a text of less than ${count} bytes, without a zero`);
                    }
                    view().fill(0, this[AT] + offset, this[AT] + offset + count);
                    view().set(bytes, this[AT] + offset);
                },
            };
        }
        if (count === 1) {
            return {
                get() { return view()[(this[AT] + offset) >>> shift]; },
                set(value) { view()[(this[AT] + offset) >>> shift] = check(value, path); },
            };
        }
        return {
            get() {
                const at = (this[AT] + offset) >>> shift, part = view().subarray(at, at + count);
                return kept(part, this);
            },
            set(values) {
                if (values?.length !== count) {
                    throw wrong(path, values, `must be ${count} numbers`);
                }
                for (let k = 0; k < count; k++) {
                    view()[((this[AT] + offset) >>> shift) + k] = check(values[k], `${path}[${k}]`);
                }
            },
        };
    }

    /** A field that is a struct. */
    function inner(path, name, offset) {
        return {
            get() { return seen_as(structs[name], this[AT] + offset, this); },
            set(values) { set_fields(seen_as(structs[name], this[AT] + offset, this), values); },
        };
    }

    function set_fields(struct, values) {
        for (const name of Object.keys(values[AT] === undefined ? values : values.constructor.fields)) {
            if (!(name in struct.constructor.fields)) {
                throw new TypeError(`${struct.constructor.name} has no field ${name}`);
            }
            struct[name] = values[name];
        }
        return struct;
    }

    /** The struct of a class at an address, within the memory of its owner. */
    function seen_as(kind, at, owner) {
        const struct = Object.create(kind.prototype);
        struct[AT] = at;
        struct[OWNER] = owner;
        return Object.preventExtensions(struct);
    }

    /** Makes the class of a struct: fields are [name, kind, offset, count], or of a struct [name, its name, offset]. */
    function structure(name, size, fields) {
        const kind = {
            [name]: class {
                constructor(values = {}) {
                    own_memory(this, size);
                    if ("struct_size" in this) {
                        this.struct_size = size;
                    }
                    set_fields(Object.preventExtensions(this), values);
                }
                /** A copy as an object of JavaScript. */
                copy() {
                    const plain = (value) => (ArrayBuffer.isView(value) ? value.slice() : value?.[AT] === undefined ? value : value.copy());
                    return Object.fromEntries(fields.map(([own]) => [own, plain(this[own])]));
                }
                [Symbol.for("nodejs.util.inspect.custom")]() { return this.copy(); }
            },
        }[name];
        for (const [own, ...how] of fields) {
            const path = `${name}.${own}`, is_plain = how[0] in views;
            Object.defineProperty(kind.prototype, own, is_plain ? field(path, ...how) : inner(path, ...how));
        }
        return Object.assign(kind, { size, fields: Object.fromEntries(fields.map(([own, ...how]) => [own, how])) });
    }

    /** Structs one behind the other. */
    class StructArray {
        constructor(kind, count) {
            own_memory(this, count * kind.size);
            [this.kind, this.length] = [kind, count];
            for (let k = 0; k < count; k++) {
                views.u4()[(this[AT] + k * kind.size) >>> 2] = kind.size;
            }
            Object.freeze(this);
        }
        /** Numbers from one struct to the next in `numbers`. */
        get stride() { return this.kind.size / 8; }
        /** All of it as a view of numbers: number `offset(path)` of struct k is numbers[k * stride + offset(path)]. */
        get numbers() {
            const part = views.f8().subarray(this[AT] >>> 3, (this[AT] + this.length * this.kind.size) >>> 3);
            return kept(part, this);
        }
        /** Where the numbers of a field begin, such as "navigation_errors.position_enu_m". */
        offset(path) {
            let kind = this.kind, offset = 0, found = [];
            for (const name of path.split(".")) {
                found = kind?.fields[name];
                if (found === undefined) {
                    throw wrong("path", path, `${kind?.name ?? "a number"} has no ${name}`);
                }
                offset += found[1];
                kind = structs[found[0]];
            }
            if (found[0] !== "f8") {
                throw wrong("path", path, "must name numbers of 64 bits with a point");
            }
            return offset / 8;
        }
        at(index) {
            if (!Number.isInteger(index) || index < -this.length || index >= this.length) {
                throw wrong("index", index, `must be from 0 to ${this.length - 1}`);
            }
            return seen_as(this.kind, this[AT] + (index < 0 ? index + this.length : index) * this.kind.size, this);
        }
        *[Symbol.iterator]() {
            for (let k = 0; k < this.length; k++) {
                yield this.at(k);
            }
        }
    }

    /** An array of a struct, all zero and with each struct_size set. */
    const array = (kind, count) => new StructArray(kind, as_u4(count, "count"));
    /** Numbers in the memory of the library. */
    const numbers = (count) => part_of(as_u4(count, "count"), 8, () => views.f8());
    /** Bytes in the memory of the library. */
    const bytes = (count) => part_of(as_u4(count, "count"), 1, () => views.c1());

    function part_of(count, size, view) {
        const owner = own_memory({}, count * size), part = view().subarray(owner[AT] / size, owner[AT] / size + count);
        return kept(part, owner);
    }

    /** Makes the class of a handle: stands for an object of the library, until close(). That of an owner lives as long as it does. */
    function handle_class(name, destroy) {
        const kind = {
            [name]: class {
                constructor(key, owner = null) {
                    Object.defineProperty(this, KEY, { value: key, writable: true });
                    if (owner) kept(this, owner);
                    else dropped_handles.register(this, { destroy, key }, this);
                }
                /** Destroys the object, unless it is lent by its owner. */
                close() {
                    if (dropped_handles.unregister(this)) wasm[destroy](this[KEY]);
                    this[KEY] = 0;
                }
            },
        }[name];
        if (Symbol.dispose) {
            kind.prototype[Symbol.dispose] = kind.prototype.close;
        }
        return kind;
    }

    const out = allocate(OUT_SIZE), texts = allocate(TEXT_SIZE);
    let borrowed = [], used = 0;

    /** Memory for the present call alone. */
    function borrow(bytes) {
        const size = Math.ceil(bytes / 8) * 8;
        if (used + size <= TEXT_SIZE) {
            used += size;
            return texts + used - size;
        }
        const at = allocate(size);
        borrowed.push({ at, size });
        return at;
    }

    function release() {
        for (const { at, size } of borrowed) {
            wasm.sins_wasm_free(at, size);
        }
        [borrowed, used] = [[], 0];
    }

    function as_handle(value, kind, name) {
        if (value === null) {
            return 0;
        }
        if (!(value instanceof kind)) {
            throw wrong(name, value, `must be a ${kind.name} of this instance of the library`);
        }
        return value[KEY];
    }

    /** The address of a struct, also of one that is given as a plain object. */
    function as_struct(value, kind, name) {
        if (value === null) {
            return 0;
        }
        if (value instanceof kind) {
            return value[AT];
        }
        if (value?.constructor !== Object) {
            throw wrong(name, value, `must be a ${kind.name}`);
        }
        return new kind(value)[AT];
    }

    /** The address of a struct that the call writes. */
    function as_written(value, kind, name) {
        if (value !== null && !(value instanceof kind)) {
            throw wrong(name, value, `must be a ${kind.name}`);
        }
        return value === null ? 0 : value[AT];
    }

    function as_text(value, name) {
        if (value === null) {
            return 0;
        }
        if (typeof value !== "string" || value.includes("\0")) {
            throw wrong(name, value, "must be a text without a zero");
        }
        return as_bytes(`${value}\0`, name).at;
    }

    const NOTHING = { at: 0, count: 0 };
    const is_ours = (value) => value?.buffer === wasm.memory.buffer;

    function as_bytes(value, name) {
        if (value === null) {
            return NOTHING;
        }
        let bytes = typeof value === "string" ? UTF8.encode(value) : value instanceof ArrayBuffer ? new Uint8Array(value) : value;
        if (!ArrayBuffer.isView(bytes)) {
            throw wrong(name, value, "must be a text or bytes");
        }
        if (!is_ours(bytes)) {
            const at = borrow(bytes.byteLength);
            views.c1().set(new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength), at);
            return { at, count: bytes.byteLength };
        }
        return { at: bytes.byteOffset, count: bytes.byteLength };
    }

    function as_numbers(value, name) {
        if (value === null) {
            return NOTHING;
        }
        if (value instanceof Float64Array && is_ours(value)) {
            return { at: value.byteOffset, count: value.length };
        }
        const numbers = Float64Array.from(value, (one, k) => as_f8(one, `${name}[${k}]`)), at = borrow(numbers.byteLength);
        views.f8().set(numbers, at >>> 3);
        return { at, count: numbers.length };
    }

    function as_structs(value, kind, name) {
        if (Array.isArray(value)) {
            const at = borrow(value.length * kind.size);
            for (const [k, one] of value.entries()) {
                const from = as_struct(one, kind, `${name}[${k}]`);
                views.c1().copyWithin(at + k * kind.size, from, from + kind.size);
            }
            return { at, count: value.length };
        }
        return value instanceof kind ? { at: value[AT], count: 1 } : as_records(value, kind, name);
    }

    function as_records(value, kind, name) {
        if (value === null) {
            return NOTHING;
        }
        if (!(value instanceof StructArray) || value.kind !== kind) {
            throw wrong(name, value, `must be an array as sins.array(sins.${kind.name}, count) makes it`);
        }
        return { at: value[AT], count: value.length };
    }

    function as_room(value, name) {
        if (value !== null && !(value instanceof Uint8Array && is_ours(value))) {
            throw wrong(name, value, "must be bytes as sins.bytes(count) makes them");
        }
        return value === null ? NOTHING : { at: value.byteOffset, count: value.length };
    }

    /** The text that a call writes into a buffer. */
    function written(call, sim) {
        let capacity = 2048, buffer = borrow(capacity), status = call(buffer, capacity, out);
        if (status === ERROR_BUFFER_TOO_SMALL) {
            capacity = views.u4()[out >>> 2];
            buffer = borrow(capacity);
            status = call(buffer, capacity, out);
        }
        done(status, sim);
        return text_at(buffer, capacity);
    }

    /** Keeps the status, and throws what the library says of a call that failed: of a simulator, or of the thread. */
    function done(status, sim = 0) {
        last_status = status;
        if (status < 0) {
            const info = new structs.error_info();
            wasm.sins_last_error_info(sim, info[AT]);
            if (info.status === status) {
                wasm.sins_last_error(sim, texts, TEXT_SIZE, 0);
                throw new SinsError(status, text_at(texts, TEXT_SIZE), info);
            }
            info.status = status; // a call whose handle was rejected keeps no sentence
            throw new SinsError(status, text_at(wasm.sins_status_string(status) >>> 0, TEXT_SIZE), info);
        }
        return status;
    }

    /** What a call returns that returns several things, of which some may have been given a place. */
    function answer(status, results) {
        const found = results.filter((one) => one !== undefined);
        if (found.length === 0) {
            return status;
        }
        return status === NEED_SAMPLE ? null : found.length === 1 ? found[0] : found;
    }

    /** A defect of the library stops the instance in the midst of a call: it cannot be used any more. */
    function trapped(error) {
        if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) {
            return error;
        }
        const ended = new SinsError(ERROR_INTERNAL, `a defect of the library (${error.message}): load it again`);
        const { memory } = wasm;
        wasm = new Proxy({}, { get: (_, name) => (name === "memory" ? memory : () => { throw ended; }) });
        has_ended = true;
        return ended;
    }

    const structs = {
        // <structs>
    };

    const handles = {
        // <handles>
    };

    const functions = {
        // <functions>
    };

    /** The bytes that snapshot_save() writes. */
    function snapshot(sim) {
        const saved = bytes(functions.snapshot_size(sim));
        return saved.slice(0, functions.snapshot_save(sim, saved));
    }

    const version = functions.abi_version();
    if (version !== CONSTANTS.HEADER_ABI) {
        throw new Error(`sins.wasm has version ${version} of the interface, sins.mjs is for version ${CONSTANTS.HEADER_ABI}: take both from one release`);
    }
    return {
        ...CONSTANTS,
        ...structs,
        ...handles,
        ...functions,
        array,
        numbers,
        bytes,
        snapshot,
        get last_status() {
            return last_status;
        },
    };
}
