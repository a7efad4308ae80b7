import { HOST_CONTRACT, type HostInput, type HostMethod, type HostOutput } from '../contract/contract.ts';
import { type Answer, HostError } from '../contract/host-error.ts';
import { refusal } from './file-errors.ts';

/** The function for each call of the contract. `client` is the window or tab that calls. */
export type Handlers = { readonly [M in HostMethod]: (input: HostInput<M>, client: string) => Promise<HostOutput<M>> };

/** Validates a call against the contract and runs it. Never rejects; errors are returned. */
export async function dispatch(
  handlers: Handlers,
  method: string,
  input: unknown,
  client: string,
  log: (message: string) => void,
): Promise<Answer<unknown>> {
  try {
    if (!isMethod(method)) throw refusal('SCR073', `Unknown method ${JSON.stringify(method)}.`);
    return { output: await call(handlers, method, input, client) };
  } catch (error) {
    if (error instanceof HostError) return { diagnostic: error.diagnostic };
    log(error instanceof Error ? (error.stack ?? error.message) : String(error));
    const message = `Scrim has an internal error in ${method}: ${error instanceof Error ? error.message : String(error)}`;
    return { diagnostic: { code: 'SCR074', severity: 'error', message } };
  }
}

function isMethod(name: string): name is HostMethod {
  return Object.hasOwn(HOST_CONTRACT, name);
}

function call<M extends HostMethod>(handlers: Handlers, method: M, input: unknown, client: string): Promise<HostOutput<M>> {
  const checked = HOST_CONTRACT[method].input.safeParse(input);
  if (!checked.success) {
    const [issue] = checked.error.issues;
    throw refusal('SCR073', `Invalid call of ${method}: ${issue?.path.join('.') || 'the input'}: ${issue?.message ?? 'not understood'}`);
  }
  return handlers[method](checked.data as HostInput<M>, client);
}
