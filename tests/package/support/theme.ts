/** A shop's template languages, as far as the guides use them: Liquid with Shopify's own words, and PHP between HTML. */
import { Liquid, Tag, type TagToken, type Template, type TopLevelToken } from "liquidjs";
import { Engine } from "php-parser";

/** A section of a Shopify theme as its page has it. @throws Error for what the engine does not know. */
export async function renderSection(source: string, scope: object): Promise<string> {
  const liquid = new Liquid({ strictFilters: true });
  liquid.registerFilter("asset_url", (name: string) => `/assets/${name}`);
  liquid.registerTag(
    "form",
    class extends Tag {
      readonly #within: Template[];
      constructor(token: TagToken, rest: TopLevelToken[], engine: Liquid) {
        super(token, rest, engine);
        this.#within = within(engine, rest, "endform");
      }
      *render(context: never, emitter: { write: (text: string) => void }) {
        emitter.write('<form method="post" action="/cart/add">');
        yield this.liquid.renderer.renderTemplates(this.#within, context, emitter as never);
        emitter.write("</form>");
      }
    },
  );
  liquid.registerTag(
    "schema",
    class extends Tag {
      constructor(token: TagToken, rest: TopLevelToken[], engine: Liquid) {
        super(token, rest, engine);
        const text = within(engine, rest, "endschema").map((template) => template.token.getText());
        JSON.parse(text.join(""));
      }
      *render() {}
    },
  );
  return await liquid.parseAndRender(source, scope);
}

function within(engine: Liquid, rest: TopLevelToken[], end: string): Template[] {
  const templates: Template[] = [];
  while (rest.length > 0) {
    const token = rest.shift() as TopLevelToken;
    if ("name" in token && token.name === end) return templates;
    templates.push(engine.parser.parseToken(token, rest));
  }
  throw new Error(`${end} is missing`);
}

/**
 * What a PHP file writes between its tags, after all of it was parsed; `values` stand for what it prints itself.
 * @throws Error naming the line of a syntax fault
 */
export function htmlOfPhp(source: string, values: Readonly<Record<string, string>>): string {
  new Engine({ parser: { php7: true, suppressErrors: false }, ast: { withPositions: true } }).parseCode(
    source,
    "plugin",
  );
  const html = source.slice(source.indexOf("?>") + 2, source.lastIndexOf("<?php"));
  return html.replace(/<\?=\s*(.*?)\s*\?>/g, (_, printed: string) => {
    const value = values[printed];
    if (value === undefined) throw new Error(`the plugin prints ${printed}, which has no value here`);
    return value;
  });
}
