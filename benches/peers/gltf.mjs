// Checks every .glb file in some folders with the Khronos glTF validator.
//
//     cargo run --release --example catalogue -- --gltf --out out/catalogue
//     cargo run --release --example apartment -- --out out/apartment
//     npm install --prefix peers gltf-validator
//     NODE_PATH=peers/node_modules node benches/peers/gltf.mjs out/catalogue out/apartment
//
// Prints for each kind of message its count and the place of the first; the exit status is 1
// if any of them is an error.

import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

let validator;
try {
  validator = createRequire(import.meta.url)("gltf-validator");
} catch {
  console.log("SKIPPED: gltf-validator is not installed; see the head of this file");
  process.exit(0);
}

const models = process.argv.slice(2).flatMap((folder) =>
  readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".glb")).map((name) => join(folder, name)),
);
if (models.length === 0) {
  console.error("no .glb file in the folders named");
  process.exit(2);
}

const SEVERITY = ["error", "warning", "information", "hint"];
const kinds = new Map();
for (const path of models) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), { uri: path, maxIssues: 0 });
  for (const { code, severity, message, pointer } of report.issues.messages) {
    const kind = kinds.get(code) ?? { severity, count: 0, first: `${path} ${pointer ?? ""}: ${message}` };
    kind.count += 1;
    kinds.set(code, kind);
  }
}
for (const [code, { severity, count, first }] of kinds) {
  console.log(`${SEVERITY[severity]} ${code}: ${count}, first in ${first}`);
}
const errors = [...kinds.values()].filter((k) => k.severity === 0).reduce((sum, k) => sum + k.count, 0);
console.log(`${models.length} models, ${errors} errors, by the Khronos validator ${validator.version()}`);
process.exit(errors > 0 ? 1 : 0);
