import { Panel } from '@xyflow/react';
import { createContext, type ReactNode, useContext, useMemo } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { BUDGETS, type Cost, costAt, costsOf, costWords, type Device, megabytes, overBudget, totalOf } from '../state/costs.ts';
import { nodePath } from '../state/looks.ts';
import { Icon } from '../ui/icon.tsx';
import './costs.css';

const CostsContext = createContext<ReadonlyMap<string, Cost> | null>(null);

/** Works costs out once for all nodes; does nothing while they are not shown. */
export function CostsProvider({ children }: { readonly children: ReactNode }) {
  const { costs, compile } = useEditor();
  const on = useStore(costs, (state) => state.on);
  const device = useStore(costs, (state) => state.device);
  const measured = useStore(costs, (state) => state.measured);
  const program = useStore(compile, (state) => (on ? state.program : null));
  const all = useMemo(() => program && costsOf(program, measured, device), [program, measured, device]);
  return <CostsContext value={all}>{children}</CostsContext>;
}

/** What a node costs, above its head. */
export function NodeCost({ id }: { readonly id: string }) {
  const costs = useContext(CostsContext);
  return costs && <CostLine costs={costs} id={id} />;
}

function CostLine({ costs, id }: { readonly costs: ReadonlyMap<string, Cost>; readonly id: string }) {
  const path = useDocument((state) => nodePath(state, id));
  const cost = costAt(costs, path);
  if (!cost) return null;
  const isFree = cost.passes === 0 && cost.draws === 0 && cost.targets === 0;
  return <span className={isFree ? 'node-cost node-cost-free' : 'node-cost'}>{costWords(cost)}</span>;
}

/** All of it, against what a device can bear. */
export function CostPanel() {
  const editor = useEditor();
  const costs = useContext(CostsContext);
  const device = useStore(editor.costs, (state) => state.device);
  if (!costs) return null;
  const total = totalOf(costs.values());
  return (
    <Panel position="top-right" className="cost-panel">
      <section aria-label="Cost of a frame">
        <label>
          Budget for a
          <select
            className="select"
            aria-label="Device of the budget"
            value={device}
            onChange={(event) => editor.costs.setState({ device: event.target.value as Device })}
          >
            {Object.entries(BUDGETS).map(([name, { label }]) => (
              <option key={name} value={name}>
                {label.toLowerCase()}
              </option>
            ))}
          </select>
        </label>
        <dl>
          <Figure label="Passes" value={String(total.passes)} of={String(BUDGETS[device].passes)} />
          <Figure label="Draws" value={String(total.draws)} of={String(BUDGETS[device].draws)} />
          <Figure label="Pictures" value={String(total.targets)} />
          <Figure label="Memory" value={megabytes(total.bytes)} of={megabytes(BUDGETS[device].bytes)} />
          <Figure label="GPU, here" value={total.gpuMs === null ? 'not told' : `${total.gpuMs.toFixed(2)} ms`} />
        </dl>
        {overBudget(total, device).map((problem) => (
          <p key={problem} className="cost-warning">
            <Icon name="warning" size={14} />
            {problem}
          </p>
        ))}
      </section>
    </Panel>
  );
}

function Figure({ label, value, of }: { readonly label: string; readonly value: string; readonly of?: string }) {
  return (
    <>
      <dt>{label}</dt>
      <dd>
        {value}
        {of !== undefined && <span> of {of}</span>}
      </dd>
    </>
  );
}
