// Prints every size, offset and constant of sins.mjs, like the program of layout_c.awk does for the header.

const { load } = await import(process.env.SINS_MODULE);
const sins = await load();
const SIZES = { f8: 8, i4: 4, u4: 4, i8: 8, u8: 8, c1: 1 };

for (const [name, value] of Object.entries(sins)) {
    if (value.fields !== undefined) {
        console.log(`sizeof(sins_${name})`, value.size);
        console.log(`SINS_SIZEOF_${name.toUpperCase()}`, value.size);
        for (const [field, [kind, offset, count]] of Object.entries(value.fields)) {
            console.log(`sins_${name}.${field}`, offset);
            console.log(`sizeof(sins_${name}.${field})`, kind in SIZES ? SIZES[kind] * count : sins[kind].size);
        }
    } else if (typeof value === "number" && name === name.toUpperCase()) {
        console.log(`SINS_${name}`, value);
    }
}
