// Digests of the flights of tests/c/digests.c in Node: `node tests/web/digests.mjs FOLDER`, with sins.mjs and sins.wasm in FOLDER. Each
// must be the digest of the C program.

import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { Flights } from "./flights.mjs";

/** The digests that the C program expects, by the names of its flights. */
export function expected() {
    const source = readFileSync(new URL("../c/digests.c", import.meta.url), "utf8");
    const rows = source.matchAll(/\{"([^"]+)", \w+, UINT64_C\(0x([0-9a-f]+)\)\}/g);
    return new Map(Array.from(rows, ([, name, digest]) => [name, digest]));
}

/** Prints and compares digests; whether all are there and equal. */
export function are_expected(found) {
    const wanted = expected();
    for (const [name, digest] of found) {
        console.log(`digests: ${digest} ${name}`);
    }
    return wanted.size === 5 && found.length === 5 && found.every(([name, digest]) => wanted.get(name) === digest);
}

if (process.argv[1].endsWith("digests.mjs")) {
    const { load } = await import(pathToFileURL(resolve(process.argv[2], "sins.mjs")));
    process.exitCode = are_expected([...new Flights(await load()).digests()]) ? 0 : 1;
}
