import { isEntryId, isNodeId, isNodeType, isPortName, isShaderFile } from '../document-names.ts';
import type { NameRule } from '../json/shape-reader.ts';
import { parseWire } from '../wires.ts';

export const NODE_ID: NameRule = {
  is: isNodeId,
  words: 'a node id is a readable stem, a hyphen and a suffix, in lower-case letters and digits: sepia-k7q2.',
};
export const GRAPH_NAME: NameRule = { is: isEntryId, words: 'a graph is named with lower-case letters, digits and hyphens.' };
export const ENTRY_ID: NameRule = { is: isEntryId, words: 'this id must be made of lower-case letters, digits and hyphens.' };
export const PORT_NAME: NameRule = {
  is: isPortName,
  words: 'ports and params are named with letters, digits and underscores, and begin with no digit.',
};
export const NODE_TYPE: NameRule = { is: isNodeType, words: 'a node type is a category, a slash and a name: filter/sepia.' };
export const SHADER_FILE: NameRule = {
  is: isShaderFile,
  words: 'a shader file is a name without folders that ends in .fs, .vs or .glsl; pieces to include lie in chunks/, and end in .glsl.',
};
export const WIRE: NameRule = {
  is: (text) => parseWire(text) !== null,
  words: 'a wire is written from output to input: video-a1b2.layer -> sepia-k7q2.inputImage.',
};
