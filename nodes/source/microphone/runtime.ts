import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { levelOf, silence } from '../../kit/sound.ts';
import type { definition } from './definition.ts';
import { listen } from './listen.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { audio, level } = ctx.outputs;
  silence(audio);
  level.value = 0;
  // A render has no visitor to ask, and must be reproducible.
  const ear = ctx.clock.held
    ? null
    : listen((message, fix) =>
        ctx.report({ code: 'SCR055', severity: 'warning', message: `${message} Effects that react to sound behave as in silence.`, fix }),
      );
  return {
    update: () => {
      if (ear?.hear(audio, ctx.params.gain.value) !== true) silence(audio);
      level.value = levelOf(audio);
    },
    dispose: () => ear?.dispose(),
  };
}
