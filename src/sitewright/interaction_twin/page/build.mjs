// Builds the page into ../web/static: one script, one style sheet, the licences of what is in them.
import { build } from "esbuild";
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "web", "static");

const result = await build({
  absWorkingDir: here,
  entryPoints: { app: "src/app.tsx", page: "src/style/page.css" },
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "none", // THIRD_PARTY.txt names everything, also what has no such comment
  charset: "utf8",
  metafile: true,
  outdir: out,
});

const packages = [
  ...new Set(
    Object.keys(result.metafile.inputs)
      .map((path) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1])
      .filter((name) => name !== undefined),
  ),
].sort();
writeFileSync(join(out, "THIRD_PARTY.txt"), packages.map(notice).join("\n"));
copyFileSync(join(here, "src", "index.html"), join(out, "index.html"));
copyFileSync(join(here, "src", "icon.svg"), join(out, "icon.svg"));

function notice(name) {
  const folder = join(here, "node_modules", name);
  const { version, license, homepage = "" } = JSON.parse(readFileSync(join(folder, "package.json")));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} ${version} has no licence file: add its text by hand`);
  const text = readFileSync(join(folder, file), "utf8").replaceAll("\r\n", "\n").trim();
  return `${name} ${version} (${license}) ${homepage}\n${"-".repeat(72)}\n${text}\n`;
}
