// validate_glb.js FILE...: prints every issue that Khronos' glTF validator has with a file; exit code 1 if there is any
// but hints.
const fs = require("fs");
const validator = require("gltf-validator");

const kInformation = 2;

(async () => {
  let wrong = 0;
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 20});
    for (const issue of report.issues.messages.filter((one) => one.severity <= kInformation)) {
      console.log(`${file}: ${issue.pointer || ""}: ${issue.code}: ${issue.message}`);
      wrong += 1;
    }
    if (report.mimeType !== "model/gltf-binary") wrong += 1;
  }
  process.exit(wrong ? 1 : 0);
})().catch((error) => {
  console.log(String(error));
  process.exit(1);
});
