import { parentPort, workerData } from 'node:worker_threads';
import { libraryOf } from '../../../nodes/kit/definition.ts';
import { compile } from '../../compiler/compile.ts';
import type { CompileWork } from './compile-apart.ts';

const { project, definitions, shaders, options } = workerData as CompileWork;
parentPort?.postMessage(compile({ project, library: libraryOf(definitions, shaders), options }));
