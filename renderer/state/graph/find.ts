import { MAIN_GRAPH } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { searchable } from '../../spellings.ts';
import type { DocumentState } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { titleOfName } from '../editor/library.ts';
import { nodeTitle } from '../editor/node-title.ts';
import { valueText } from '../params/value-text.ts';
import { goToNode, pathToGraph } from './graph-path.ts';

export interface Found {
  readonly graph: string;
  readonly node: string;
  readonly title: string;
  /** The matching param value; else the node id, because titles may repeat. */
  readonly detail: string;
}

const MOST = 200;

/** Finds nodes of all graphs by name, type, id or param value. Nodes of the open graph come first. */
export function findNodes({ project, library, graph }: DocumentState, query: string): readonly Found[] {
  const words = searchable(query).split(/\s+/).filter(Boolean);
  const names = [graph, ...Object.keys(project.graphs).filter((name) => name !== graph)];
  const found: Found[] = [];
  for (const name of names) {
    for (const [id, node] of Object.entries(getOwn(project.graphs, name)?.nodes ?? {})) {
      const definition = library.definition(node.type);
      const title = nodeTitle(node, library, project.assets);
      const values = Object.entries(node.params).flatMap(([param, binding]) => {
        const known = definition && getOwn(definition.params, param);
        return known ? [`${known.label} ${valueText(known, binding)}`] : [];
      });
      const text = searchable([title, definition?.title ?? '', id, ...values].join('\n'));
      if (!words.every((word) => text.includes(word))) continue;
      const inTitle = words.every((word) => searchable(title).includes(word));
      const value = inTitle ? undefined : values.find((line) => words.some((word) => searchable(line).includes(word)));
      found.push({ graph: name, node: id, title, detail: value ?? id });
    }
  }
  const starts = ({ title }: Found) => (words[0] !== undefined && searchable(title).startsWith(words[0]) ? 0 : 1);
  return found.sort((a, b) => Number(a.graph !== graph) - Number(b.graph !== graph) || starts(a) - starts(b)).slice(0, MOST);
}

export function titleOfGraph(name: string): string {
  return name === MAIN_GRAPH ? 'Main graph' : titleOfName(name);
}

export function goToFound(editor: Editor, { graph, node }: Found): void {
  goToNode(editor, { graph, node, trail: pathToGraph(editor.document.getState().project, graph) });
}
