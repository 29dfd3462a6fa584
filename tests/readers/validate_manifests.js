// validate_manifests.js FILES...: fails if a manifest of Kubernetes is not as the schema of its kind says, or has a field that the schema
// does not know. The validators pass over unknown fields: these are the ones that nobody has read.
const { readFileSync } = require("node:fs");
const { parseAllDocuments } = require("yaml");

/** The same value, which calls `unread` for each field that was never read when `check` is called. */
function watched(value, path, checks) {
  if (typeof value !== "object" || value === null) return value;
  const inner = Array.isArray(value) ? [] : {};
  for (const [name, part] of Object.entries(value)) inner[name] = watched(part, `${path}/${name}`, checks);
  const read = new Set();
  checks.push(() => Object.keys(inner).filter((name) => !read.has(name)).map((name) => `${path}/${name}`));
  return new Proxy(inner, {
    get(target, name) {
      read.add(name);
      return target[name];
    },
  });
}

let wrong = 0;
for (const file of process.argv.slice(2))
  for (const document of parseAllDocuments(readFileSync(file, "utf8"))) {
    const manifest = document.toJS();
    const Kind = require(`kubernetes-models/${manifest.apiVersion}/${manifest.kind}`)[manifest.kind];
    const checks = [];
    try {
      Kind.prototype.validate.call(watched(manifest, "", checks));
      const unknown = checks.flatMap((check) => check());
      if (unknown.length > 0) throw new Error(`unknown fields: ${unknown.join(", ")}`);
      console.log(`${file}: ${manifest.kind} ${manifest.metadata.name}`);
    } catch (error) {
      console.error(`${file}: ${manifest.kind}: ${error.message}`);
      wrong = 1;
    }
  }
process.exit(wrong);
