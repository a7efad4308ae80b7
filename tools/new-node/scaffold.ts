import { saveProject } from '../../export/graph/save.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { LAYER_TEMPLATE } from './layer-template.ts';
import { OBJECTS_TEMPLATE } from './objects-template.ts';
import { surround } from './surround.ts';
import type { Template } from './template.ts';
import { VALUE_TEMPLATE } from './value-template.ts';

const TEMPLATES = { value: VALUE_TEMPLATE, objects: OBJECTS_TEMPLATE, layer: LAYER_TEMPLATE } as const satisfies Record<string, Template>;

const TYPE = /^[a-z][a-z0-9]*(-[a-z0-9]+)*\/[a-z][a-z0-9]*(-[a-z0-9]+)*$/;

/** ISF files, subgraphs, and the folders of `nodes/` that hold no node types. */
const NO_CATEGORIES = ['filter', 'operator', 'generator', 'graph', 'kit', 'generated'];

/** Why a node type cannot be called so, or null. */
export function refuseType(type: string, library: NodeLibrary): string | null {
  const [category = ''] = type.split('/');
  if (!TYPE.test(type)) return `"${type}" is no node type: write CATEGORY/NAME in lower-case words, such as layer/fog.`;
  if (['filter', 'operator', 'generator'].includes(category)) {
    return `A ${category} is one ISF file: write shader-library/${category}s/${type.slice(category.length + 1)}.fs, and nothing else.`;
  }
  if (NO_CATEGORIES.includes(category)) return `"${category}" is no category of nodes.`;
  return library.definition(type) ? `There is a node type ${type} already.` : null;
}

/** The files of a new node folder: path in the repository → text, unformatted. */
export function scaffold(type: string, library: NodeLibrary): Readonly<Record<string, string>> {
  const [category = '', name = ''] = type.split('/');
  const template = category === 'objects' || category === 'layer' ? TEMPLATES[category] : TEMPLATES.value;
  const definition = template.definition(type, titleOf(name));
  const example = saveProject(surround(withDefinition(library, definition), type, titleOf(name)));
  const folder = `nodes/${type}`;
  return {
    [`${folder}/definition.ts`]: `import { defineNode } from '../../kit/definition.ts';\n\nexport const definition = defineNode(${JSON.stringify(definition)});\n`,
    [`${folder}/runtime.ts`]: template.runtime,
    [`${folder}/${name}.test.ts`]: template.test(type),
    [`${folder}/example/project.scrim.json`]: example.project,
    [`${folder}/example/project.layout.json`]: example.layout,
  };
}

function withDefinition(library: NodeLibrary, added: ReturnType<Template['definition']>): NodeLibrary {
  return {
    definition: (type) => (type === added.type ? added : library.definition(type)),
    shader: library.shader,
    *types() {
      yield* library.types();
      yield added.type;
    },
  };
}

/** `depth-fog` → `Depth fog`. */
function titleOf(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.slice(0, 1).toUpperCase() + words.slice(1);
}
