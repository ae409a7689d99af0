// Files and the address: what is dropped, what is saved, and the scene in the link.

import { element } from "./texts.mjs";

/** Saves a blob under a name. */
export function save(blob, name) {
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** Asks for a file. */
export function choose(accept, take) {
    const input = element("input", { type: "file", accept, id: "file" });
    input.onchange = () => input.files[0] && take(input.files[0]);
    document.getElementById("file")?.remove();
    input.hidden = true;
    document.body.append(input);
    input.click();
}

/** Takes files that are dropped on the page, one after the other: scenes first, which say what the others are. */
export function on_drop(take) {
    const over = (is_over) => document.body.classList.toggle("over", is_over);
    addEventListener("dragover", (event) => {
        event.preventDefault();
        over(true);
    });
    addEventListener("dragleave", (event) => event.relatedTarget ?? over(false));
    addEventListener("drop", async (event) => {
        event.preventDefault();
        over(false);
        const files = [...event.dataTransfer.files], is_scene = ({ name }) => name.endsWith(".toml");
        for (const file of [...files.filter(is_scene), ...files.filter((own) => !is_scene(own))]) await take(file);
    });
}

/** Longest text of a scene that the library reads [bytes]. */
const MOST_OF_TEXT = 1 << 20;

/** The text of a file; of one that is too long, what the library needs to say so. */
export const text_of = (file) => file.slice(0, MOST_OF_TEXT + 1).text();

/** Bytes, or a blob, through a compressor or its counterpart. Throws if there are more than `most`: a short link may unpack to much. */
async function through(bytes, stream, most = Infinity) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader(), pieces = [];
    for (let size = 0; size <= most; ) {
        const { done, value } = await reader.read();
        if (done) return new Uint8Array(await new Blob(pieces).arrayBuffer());
        size += value.length;
        pieces.push(value);
    }
    await reader.cancel();
    throw new Error(`more than ${most} bytes`);
}

/** Letters of base64 that are read at once, so that the page does not stand still. */
const PIECE_OF_BASE64 = 1 << 17;
/** Ends the task, so that the browser does what waits. */
const pause = () => new Promise((done) => setTimeout(done));
const bytes_of = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

/** Bytes of base64 in an element of the page, that were packed by gzip. */
export async function unpacked(id) {
    const packed = document.getElementById(id).textContent, pieces = [];
    for (let from = 0; from < packed.length; from += PIECE_OF_BASE64) {
        await pause();
        pieces.push(bytes_of(packed.slice(from, from + PIECE_OF_BASE64)));
    }
    return through(new Blob(pieces), new DecompressionStream("gzip"));
}

/** A text as a part of an address. */
export async function to_link(text) {
    const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The text of a part of an address. Throws if it is none. */
export async function of_link(part) {
    const bytes = bytes_of(part.replaceAll("-", "+").replaceAll("_", "/"));
    return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw"), MOST_OF_TEXT));
}
