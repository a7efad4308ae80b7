import { Panel } from '@xyflow/react';
import { createContext, type ReactNode, useContext, useMemo } from 'react';
import { useStore } from 'zustand';
import {
  BUDGETS,
  type Cost,
  costAt,
  costsOf,
  costWords,
  type Device,
  leftObjects,
  megabytes,
  overBudget,
  totalOf,
} from '../state/editor/cost-state.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { nodePath } from '../state/editor/layer-names.ts';
import { Icon } from '../ui/icon.tsx';
import { SelectField } from '../ui/select-field.tsx';
import './performance-overlay.css';

const DEVICES = (Object.keys(BUDGETS) as Device[]).map((value) => ({ value, label: BUDGETS[value].label.toLowerCase() }));

const CostsContext = createContext<ReadonlyMap<string, Cost> | null>(null);

/** Computes the cost of every node once, while the overlay is on. */
export function CostsProvider({ children }: { readonly children: ReactNode }) {
  const { costs, compile } = useEditor();
  const on = useStore(costs, (state) => state.on);
  const device = useStore(costs, (state) => state.device);
  const measured = useStore(costs, (state) => state.measured);
  const memory = useStore(costs, (state) => state.memory);
  const program = useStore(compile, (state) => (on ? state.program : null));
  const all = useMemo(() => program && costsOf(program, { measured, memory, device }), [program, measured, memory, device]);
  return <CostsContext value={all}>{children}</CostsContext>;
}

/** Cost of a node, above its title. */
export function NodeCost({ id }: { readonly id: string }) {
  const costs = useContext(CostsContext);
  return costs && <CostLine costs={costs} id={id} />;
}

function CostLine({ costs, id }: { readonly costs: ReadonlyMap<string, Cost>; readonly id: string }) {
  const path = useDocument((state) => nodePath(state, id));
  const cost = costAt(costs, path);
  if (!cost) return null;
  const isFree = cost.passes === 0 && cost.draws === 0 && cost.bytes === 0;
  return <span className={isFree ? 'node-cost node-cost-free' : 'node-cost'}>{costWords(cost)}</span>;
}

/** Panel with the total cost of the program, compared with the budget of a device. */
export function PerformancePanel() {
  const editor = useEditor();
  const costs = useContext(CostsContext);
  const device = useStore(editor.costs, (state) => state.device);
  const memory = useStore(editor.costs, (state) => state.memory);
  if (!costs) return null;
  const total = totalOf(costs.values());
  return (
    <Panel position="top-right" className="cost-panel">
      <section aria-label="Performance">
        <div className="cost-device">
          Budget for a
          <SelectField
            label="Target device"
            value={device}
            options={DEVICES}
            onChoose={(next) => editor.costs.setState({ device: next })}
          />
        </div>
        <dl>
          <Figure label="Passes" value={String(total.passes)} of={String(BUDGETS[device].passes)} />
          <Figure label="Draw calls" value={String(total.draws)} of={String(BUDGETS[device].draws)} />
          <Figure label="Render targets" value={String(total.targets)} />
          <Figure label="Memory" value={megabytes(total.bytes)} of={megabytes(BUDGETS[device].bytes)} />
          <Figure label="GPU time" value={total.gpuMs === null ? 'not reported' : `${total.gpuMs.toFixed(2)} ms`} />
        </dl>
        {[...overBudget(total, device), ...leftObjects(memory)].map((problem) => (
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
