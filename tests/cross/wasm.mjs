// Runs the module of wasm.rs, given as the first argument: its lines to standard output, the level to standard error.
import { readFile } from "node:fs/promises";

const bytes = await readFile(process.argv[2]);
const { instance } = await WebAssembly.instantiate(bytes, {});
const { memory, run, text, text_length } = instance.exports;
let trap;
try {
    run();
} catch (error) {
    trap = error;
}
const report = new TextDecoder().decode(new Uint8Array(memory.buffer, text(), text_length()));
if (trap) {
    console.error(`the module trapped (${trap.message}): ${report}`);
    process.exit(1);
}
const end = report.indexOf("\n");
console.error(report.slice(0, end));
process.stdout.write(report.slice(end + 1));
