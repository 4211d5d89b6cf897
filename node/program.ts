/** The commands, their options and their help. What they do is loaded when one is called, so that help comes at once. */
import { Command, Option } from "commander";
import packageJson from "../package.json" with { type: "json" };
import type { BakeOptions } from "./commands/bake.ts";
import type { CheckOptions } from "./commands/check.ts";
import type { InspectOptions } from "./commands/inspect.ts";
import type { PrintOptions } from "./commands/print.ts";
import type { RenderOptions } from "./commands/render.ts";
import type { SchemaOptions } from "./commands/schema.ts";
import type { UnwrapCommandOptions } from "./commands/unwrap.ts";
import type { VariantCommandOptions } from "./commands/variant.ts";
import { EXIT_BAD_INPUT } from "./exit-codes.ts";
import {
  parseBase,
  parseDpi,
  parseGlbOutput,
  parseGutter,
  parseMaterial,
  parsePath,
  parsePrintOutput,
  parsePrintSize,
  parseRenderOutput,
  parseSide,
  parseSize,
} from "./options.ts";
import { printable } from "./terminal-text.ts";

const EXIT_CODES = `
Exit codes: 0 done, 1 a fault of Texelcast's own, 2 wrong usage, 3 an input that cannot be used, a result that cannot be written, or a design that check finds unfit for print.`;

const INSPECT_EXAMPLES = `
Examples:
  texelcast inspect mug.glb
  texelcast inspect shoe/shoe.gltf --json > shoe.json`;

const BAKE_EXAMPLES = `
Examples:
  texelcast bake mug.glb --out maps
  texelcast bake skateboard.glb --out maps --material 1 --size 2048 --gutter 8

In Python:
  positions = numpy.load("maps/positions.npy")   # float32, height x width x 3, metres, model space`;

const RENDER_EXAMPLES = `
Examples:
  texelcast render mug.glb design.json --out mug-painted.glb
  texelcast render mug.glb design.json --out mug-in-the-room.usdz
  texelcast render mug.glb design.json --out print.png --size 4096
  texelcast render board.glb design.json --out "print-{material}.png"
  texelcast render shirt.glb design.json --out decals.png --material 1 --base "#ff8000"
  texelcast render shirt.glb design.json --out shirt.png --base cloth.jpg
  texelcast render shirt.texelcast --out shirt.glb`;

const CHECK_EXAMPLES = `
Examples:
  texelcast check mug.glb design.json --zones mug.zones.json
  texelcast check mug.glb design.json --zones mug.zones.json --json > report.json`;

const PRINT_EXAMPLES = `
Examples:
  texelcast print mug.glb design.json --out mug.png --size 16384
  texelcast print mug.glb design.json --zones mug.zones.json --zone wall --flattened --dpi 300 --out wall.png`;

const UNWRAP_EXAMPLES = `
Examples:
  texelcast unwrap knight.glb --out knight-unwrapped.glb
  texelcast unwrap shoe/shoe.gltf --out shoe.glb --material 1 --size 4096`;

const VARIANT_EXAMPLES = `
Examples:
  texelcast variant shoe/shoe.gltf --out street.glb --name street`;

const SCHEMA_EXAMPLES = `
Examples:
  texelcast schema > design.schema.json
  texelcast schema --zones > zones.schema.json`;

/** Of commands after the first, in their order: the program's own help has one of each. */
const OTHER_EXAMPLES = [
  BAKE_EXAMPLES,
  RENDER_EXAMPLES,
  CHECK_EXAMPLES,
  PRINT_EXAMPLES,
  UNWRAP_EXAMPLES,
  VARIANT_EXAMPLES,
  SCHEMA_EXAMPLES,
];

const oneLine = (text: string): string =>
  text
    .replace(/^error: /, "")
    .trim()
    .replace(/\n(\(Did you mean .*\?\))$/, " $1");

/** A program that throws CommanderError instead of ending the process. */
export function createProgram(): Command {
  const program = new Command("texelcast")
    .description("Paints decals into a 3D model's own texture.")
    .version(packageJson.version, "-V, --version", "print the version")
    .helpOption("-h, --help", "print this help")
    .helpCommand(false)
    .addHelpText("after", `${INSPECT_EXAMPLES}${OTHER_EXAMPLES.map(firstExample).join("")}\n${EXIT_CODES}`)
    .exitOverride()
    .configureOutput({
      // Commander says in a line of its own what may have been meant; of what is wrong there is one line.
      outputError: (text, write) => write(`texelcast: ${printable(oneLine(text))}\n`),
    })
    .showHelpAfterError("  `texelcast --help` and `texelcast COMMAND --help` tell the usage.");

  for (const add of [addInspect, addBake, addRender, addCheck, addPrint, addUnwrap, addVariant, addSchema, addHelp])
    add(program);
  return program;
}

function addInspect(program: Command): void {
  program
    .command("inspect")
    .summary("tell whether a model can take decals, and how well it is unwrapped")
    .description("Prints a model's materials, triangles, texture sizes, UV coverage and overlap, and bounds.")
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .option("--json", "print one JSON object instead of a table")
    .addHelpText("after", INSPECT_EXAMPLES)
    .action(async (model: string, options: InspectOptions) => {
      await (await import("./commands/inspect.ts")).inspect(model, options);
    });
}

function addBake(program: Command): void {
  program
    .command("bake")
    .summary("write the local space texture: positions, normals, coverage, overlap")
    .description(
      "Bakes the local space texture of one material: for each texel, where it lies on the model and which way it faces. " +
        "Writes positions, normals, coverage and overlap, each as a NumPy array and as a picture.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .addOption(new Option("--out <dir>", "folder for the files").argParser(parsePath).makeOptionMandatory())
    .addOption(new Option("--material <index>", "glTF material index").argParser(parseMaterial).default(0))
    .addOption(sizeOption("default: the material's texture, 1024 without"))
    .addOption(
      new Option("--gutter <texels>", "how far past the charts, 0 to 64 (default: 2 at 1024, in proportion)").argParser(
        parseGutter,
      ),
    )
    .addHelpText("after", BAKE_EXAMPLES)
    .action(async (model: string, options: BakeOptions) => {
      await (await import("./commands/bake.ts")).bake(model, options);
    });
}

function addRender(program: Command): void {
  program
    .command("render")
    .summary("replay a design on a model: the finished texture, or the model with it inside")
    .description(
      "Replays a design on a model. A .png holds one material's finished texture ({material} in its name: one picture for each " +
        "that the design paints); a .glb is the model with the textures " +
        "of all materials that the design paints replaced, everything else of the file as it was; a .usdz is that model at rest, " +
        "for augmented reality on iPhones and iPads.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files; left out where a project has its model inside")
    .argument("[design]", "a design document, JSON, or a project, .texelcast")
    .addOption(
      new Option("--out <file>", "FILE.png, FILE.glb, FILE.usdz, or with {material} in its name one .png each")
        .argParser(parseRenderOutput)
        .makeOptionMandatory(),
    )
    .addOption(
      new Option(
        "--material <index>",
        "glTF material index (default: 0 for one .png, else all that are painted)",
      ).argParser(parseMaterial),
    )
    .addOption(sizeOption("default: the base picture's own, 1024 without"))
    .addOption(
      new Option(
        "--base <ground>",
        'what the layers lie on: "white", "#rrggbb" or a picture (default: the material\'s own texture or colour)',
      ).argParser(parseBase),
    )
    .addHelpText("after", RENDER_EXAMPLES)
    .action(async (first: string, second: string | undefined, options: RenderOptions, command: Command) => {
      const alone = second === undefined;
      if (alone && !/\.texelcast$/i.test(first)) command.error("error: missing required argument 'design'");
      await (await import("./commands/render.ts")).render(alone ? null : first, second ?? first, options);
    });
}

function addCheck(program: Command): void {
  program
    .command("check")
    .summary("tell what the print makes of a design, and whether it may be printed")
    .description(
      "Measures each layer on the model's surface: DPI, stretch, what is clipped, hidden, outside of its print area. " +
        "Exits with 3 where something must not be printed as it is.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .argument("<design>", "a design document, JSON, or a project, .texelcast")
    .option(
      "--zones <file>",
      "the product's print areas, JSON (default: printed everywhere, at the model's own size)",
      parsePath,
    )
    .option("--json", "print the report as JSON")
    .addHelpText("after", CHECK_EXAMPLES)
    .action(async (model: string, design: string, options: CheckOptions) => {
      const mayBePrinted = await (await import("./commands/check.ts")).check(model, design, options);
      if (!mayBePrinted) process.exitCode = EXIT_BAD_INPUT;
    });
}

function addPrint(program: Command): void {
  program
    .command("print")
    .summary("write a design as a file for the printer, with its DPI")
    .description(
      "Writes the finished texture, or one zone of it, as PNG with sRGB and pHYs, up to 16384 x 16384, and prints its SHA-256. " +
        "Designs are cut off at zones that clip.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .argument("<design>", "a design document, JSON, or a project, .texelcast")
    .addOption(new Option("--out <file>", "FILE.png").argParser(parsePrintOutput).makeOptionMandatory())
    .option("--zones <file>", "the product's print areas, JSON", parsePath)
    .option("--zone <id>", "one zone alone, with its bleed; all around it is transparent")
    .option("--flattened", "the zone laid out flat, at its true size and upright")
    .addOption(
      new Option("--material <index>", "glTF material index (default: the zone's, else 0)").argParser(parseMaterial),
    )
    .addOption(
      new Option(
        "--size <texels>",
        "of the texture: N or WIDTHxHEIGHT, 1 to 16384 (default: as --dpi asks, else the material's own)",
      ).argParser(parsePrintSize),
    )
    .addOption(
      new Option("--dpi <dots>", "pixels an inch of print, at least (of flat art: exactly)").argParser(parseDpi),
    )
    .option("--no-base", "the layers alone, without the model's own picture or colour")
    .addHelpText("after", PRINT_EXAMPLES)
    .action(async (model: string, design: string, options: PrintOptions) => {
      await (await import("./commands/print.ts")).print(model, design, options);
    });
}

function addUnwrap(program: Command): void {
  program
    .command("unwrap")
    .summary("give each triangle texels of its own, where a model's parts share them or have none")
    .description(
      "Writes the model with new texture coordinates for its base colour textures, in which no two triangles of a material share a " +
        "texel, and with those textures laid on them as they looked. Other textures, skins, morph targets and animations stay.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .addOption(new Option("--out <file>", "FILE.glb").argParser(parseGlbOutput).makeOptionMandatory())
    .addOption(
      new Option(
        "--material <index>",
        "glTF material index (default: all that share texels or have no texture coordinates)",
      ).argParser(parseMaterial),
    )
    .addOption(new Option("--size <texels>", "side of the new textures, 64 to 8192").argParser(parseSide).default(2048))
    .addHelpText("after", UNWRAP_EXAMPLES)
    .action(async (model: string, options: UnwrapCommandOptions) => {
      await (await import("./commands/unwrap.ts")).unwrap(model, options);
    });
}

function addVariant(program: Command): void {
  program
    .command("variant")
    .summary("show another variant of a model's materials")
    .description(
      "Writes the model with the materials of one of its variants (KHR_materials_variants), which `inspect` lists. It keeps all of them.",
    )
    .argument("<model>", "a .glb, or a .gltf with its side files")
    .addOption(new Option("--out <file>", "FILE.glb").argParser(parseGlbOutput).makeOptionMandatory())
    .requiredOption("--name <variant>", "as the model calls it")
    .addHelpText("after", VARIANT_EXAMPLES)
    .action(async (model: string, options: VariantCommandOptions) => {
      await (await import("./commands/variant.ts")).variant(model, options);
    });
}

function addSchema(program: Command): void {
  program
    .command("schema")
    .summary("print the JSON Schema of design documents, or of zones files")
    .description(
      "Prints the JSON Schema (draft 2020-12) of design documents, or of zones files, for editors and other programs.",
    )
    .option("--zones", "that of zones files")
    .addHelpText("after", SCHEMA_EXAMPLES)
    .action(async (options: SchemaOptions) => {
      await (await import("./commands/schema.ts")).schema(options);
    });
}

function addHelp(program: Command): void {
  program
    .command("help")
    .summary("print the help of a command")
    .description("Prints the help of a command, or without one that of the program.")
    .argument("[command]", "as in `texelcast help render`")
    .action(async (name?: string) => {
      const asked = name === undefined ? program : program.commands.find((command) => command.name() === name);
      if (asked) asked.help();
      // Commander's own help command prints all of the usage and does not say why; called, a command that is none is named.
      else await program.parseAsync([name as string], { from: "user" });
    });
}

const sizeOption = (what: string): Option =>
  new Option("--size <texels>", `N or WIDTHxHEIGHT, 1 to 8192 (${what})`).argParser(parseSize);

/** To stand in a list with others'. */
const firstExample = (examples: string): string => `\n${examples.split("\n")[2]}`;
