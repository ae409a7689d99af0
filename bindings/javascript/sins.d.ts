/*
 * sins.h for TypeScript: the types of sins.mjs, whose first comment says how it is used.
 *
 * This file is written by build/ from the Rust sources; do not edit it.
 */

/** A call that failed: its status, the library's sentence, and in info what the sentence is made of. */
export class SinsError extends Error {
    readonly status: number;
    readonly info: error_info | null;
}

/**
 * Loads the library: sins.wasm beside sins.mjs, or what source is: an address, bytes, a Response, or a WebAssembly.Module. Each call
 * makes an instance with memory of its own.
 */
export function load(source?: string | URL | Response | BufferSource | WebAssembly.Module): Promise<Sins>;

/** The values of the fields of a struct; fields that are not named are 0. */
export type Values<T> = {
    [K in keyof T]?: T[K] extends Float64Array | Int32Array | Uint32Array | BigUint64Array
        ? ArrayLike<number | bigint>
        : T[K] extends bigint
          ? number | bigint
          : T[K] extends number | string
            ? T[K]
            : Values<T[K]>;
};

/** The class of a struct: its size in bytes, and the kind, offset and count of each field. */
export interface Class<T> {
    new (values?: Values<T>): Struct<T>;
    readonly size: number;
    readonly fields: Readonly<Record<keyof T, readonly (string | number)[]>>;
}

/** A struct in the memory of the library. */
export type Struct<T> = T & {
    /** A copy as an object of JavaScript. */
    copy(): T;
};

/** Structs one behind the other in the memory of the library. */
export interface StructArray<T> extends Iterable<Struct<T>> {
    readonly kind: Class<T>;
    readonly length: number;
    /** Numbers from one struct to the next in `numbers`. */
    readonly stride: number;
    /** All of it as a view of numbers: the first number of a field of struct k is numbers[k * stride + offset(path)]. */
    readonly numbers: Float64Array;
    /** Where the numbers of a field begin, such as "navigation_errors.position_enu_m". */
    offset(path: string): number;
    /** The struct at a place; -1 is the last. */
    at(index: number): Struct<T>;
}

/** Stands for an object of the library, which is destroyed by close() or when the handle is dropped. */
export interface Handle {
    close(): void;
}

// <handles>

// <structs>

/** The library. */
export interface Sins {
    /** The status of the last call. */
    readonly last_status: number;
    /** An array of a struct, all zero and with each struct_size set. */
    array<T>(kind: Class<T>, count: number): StructArray<T>;
    /** Numbers in the memory of the library. */
    numbers(count: number): Float64Array;
    /** Bytes in the memory of the library. */
    bytes(count: number): Uint8Array;
    /** The bytes that snapshot_save() writes. */
    snapshot(sim: sim): Uint8Array;

    // <members>
}
