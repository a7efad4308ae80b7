/**
 * Copies objects, each once. React Flow reads the handles of a node when it gets a new object for it, and later measures those that are drawn,
 * of which an overview has none. So the nodes of an overview are copies: when it ends, React Flow reads the handles again, also those of nodes
 * out of view, without which it draws no wires.
 */
export function createCopies<Node extends object>(): (node: Node) => Node {
  const copies = new WeakMap<Node, Node>();
  return (node) => {
    const known = copies.get(node);
    if (known) return known;
    const copy = { ...node };
    copies.set(node, copy);
    return copy;
  };
}
