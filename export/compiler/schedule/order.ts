import { topologicalOrder } from '../../graph/topology.ts';
import type { ResourceId } from '../../program/program.ts';
import type { ScheduledOperation, Step } from './scheduled.ts';

/**
 * Puts the operations into the order in which the runtime plays them: once a frame, then once per view.
 *
 * Once: kind by kind as far as they depend on each other, values first (docs/ARCHITECTURE.md, “Drawing”), and in the order of the
 * graph among equals.
 *
 * Per view: so that few pictures are kept at a time, because each is a target of the size of the view. Choosing the best order
 * is NP-complete for graphs that share results (Sethi 1975), so it is the rule of Sethi and Ullman (1970) for trees, used on the
 * graph as Blender's compositor does: of the pictures that an operation reads, the one that needs the most buffers itself is
 * made first, while none of the others takes up room. What goes onto the screen comes last, in painter's order and all at once:
 * leaving the session's framebuffer and coming back would make a tiled GPU store and load it. `onScreen` names those operations.
 *
 * Last come the operations that write `delayed` images: until then these show the previous frame.
 */
export function orderOperations(
  steps: readonly Step[],
  onScreen: readonly string[],
  delayed: ReadonlySet<ResourceId>,
): ScheduledOperation[] {
  const isCapture = ({ operation }: Step) => operation.writes.some((resource) => delayed.has(resource));
  const each = steps.filter(runs('each'));
  const frame = orderEach(
    each.filter((step) => !isCapture(step)),
    onScreen,
  );
  const ordered = [...orderOnce(steps.filter(runs('once'))), ...frame, ...orderCaptures(each.filter(isCapture))];
  return ordered.map(({ operation }) => operation);
}

function runs(view: 'once' | 'each') {
  return ({ operation }: Step) => operation.view === view;
}

const ONCE_KINDS: readonly ScheduledOperation['kind'][] = ['value', 'source', 'behavior', 'geometry', 'shadow-maps', 'pass', 'cpu'];

function orderOnce(steps: readonly Step[]): Step[] {
  const rank = ({ operation }: Step) => ONCE_KINDS.indexOf(operation.kind);
  const sorted = [...steps].sort((a, b) => rank(a) - rank(b));
  return needsFirst(sorted, stepsById(steps), ({ after }) => after);
}

function orderEach(steps: readonly Step[], onScreen: readonly string[]): Step[] {
  const byId = stepsById(steps);
  const buffers = buffersNeeded(steps, byId);
  const mostFirst = ({ after }: Step) => [...after].sort((a, b) => (buffers.get(b) ?? 0) - (buffers.get(a) ?? 0));
  const screen = onScreen.flatMap((id) => byId.get(id) ?? []);
  const shown = screen.flatMap(mostFirst).flatMap((id) => byId.get(id) ?? []);
  const last = new Set(screen);
  const pictures = needsFirst([...shown, ...steps.filter((step) => !last.has(step))], byId, mostFirst);
  return [...pictures, ...screen];
}

/** A capture of what another one keeps comes before it, for the picture of this frame. Captures of each other alone never hold any. */
function orderCaptures(steps: readonly Step[]): Step[] {
  const readersOf = ({ operation }: Step) =>
    steps
      .filter((other) => other.operation.reads.some((resource) => operation.writes.includes(resource)))
      .map((other) => other.operation.id);
  return needsFirst(steps, stepsById(steps), readersOf);
}

/** How many pictures there are at most while that of a step is made, what it needs in the best order. Sethi and Ullman's labels. */
function buffersNeeded(steps: readonly Step[], byId: ReadonlyMap<string, Step>): ReadonlyMap<string, number> {
  const followers = new Map<string, string[]>(steps.map(({ operation }) => [operation.id, []]));
  for (const { operation, after } of steps) for (const id of after) followers.get(id)?.push(operation.id);
  const buffers = new Map<string, number>();
  for (const id of topologicalOrder(followers.keys(), (vertex) => followers.get(vertex) ?? []).order) {
    const needs = (byId.get(id)?.after ?? []).map((before) => buffers.get(before) ?? 0).sort((a, b) => b - a);
    buffers.set(id, Math.max(1, ...needs.map((need, kept) => need + kept)));
  }
  return buffers;
}

/** Each root after all that it needs, depth first; with a stack of its own, because chains can be long. */
function needsFirst(roots: readonly Step[], byId: ReadonlyMap<string, Step>, needs: (step: Step) => readonly string[]): Step[] {
  const ordered: Step[] = [];
  const seen = new Set<Step>();
  for (const root of roots) {
    const open: { readonly step: Step; readonly rest: string[] }[] = [];
    const enter = (step: Step) => {
      if (seen.has(step)) return;
      seen.add(step);
      open.push({ step, rest: [...needs(step)].reverse() });
    };
    enter(root);
    for (let top = open.at(-1); top; top = open.at(-1)) {
      const id = top.rest.pop();
      const need = id === undefined ? undefined : byId.get(id);
      if (need) enter(need);
      else if (id === undefined) {
        ordered.push(top.step);
        open.pop();
      }
    }
  }
  return ordered;
}

function stepsById(steps: readonly Step[]): ReadonlyMap<string, Step> {
  return new Map(steps.map((step) => [step.operation.id, step]));
}
