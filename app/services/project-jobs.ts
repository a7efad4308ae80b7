import { refusal } from './file-errors.ts';

/** Jobs that an editor works on over several calls, one per open project. */
export interface ProjectJobs<Job> {
  /** Cancels an earlier job of the project. */
  begin(projectId: string, client: string, job: Job): Promise<void>;
  /** @throws SCR073 if there is none */
  of(projectId: string): Job;
  /** Whether this is the job of the project still. */
  has(projectId: string, job: Job): boolean;
  /** Ends a job without discarding what it made. */
  complete(projectId: string): void;
  /** Resolves when all that the job made is deleted. */
  cancel(projectId: string): Promise<void>;
  /** Cancels the jobs of a closed window or tab. */
  left(client: string): void;
  dispose(): void;
}

/**
 * @param none What is said if there is no job.
 * @param discard Deletes all that a job made. Never rejects.
 */
export function createProjectJobs<Job>(none: string, discard: (job: Job) => Promise<void>): ProjectJobs<Job> {
  const jobs = new Map<string, { readonly client: string; readonly job: Job }>();
  const cancel = async (projectId: string): Promise<void> => {
    const entry = jobs.get(projectId);
    jobs.delete(projectId);
    if (entry) await discard(entry.job);
  };
  return {
    begin: async (projectId, client, job) => {
      await cancel(projectId);
      jobs.set(projectId, { client, job });
    },
    of: (projectId) => {
      const entry = jobs.get(projectId);
      if (!entry) throw refusal('SCR073', none);
      return entry.job;
    },
    has: (projectId, job) => jobs.get(projectId)?.job === job,
    complete: (projectId) => {
      jobs.delete(projectId);
    },
    cancel,
    left: (client) => {
      for (const [projectId, entry] of jobs) if (entry.client === client) void cancel(projectId);
    },
    dispose: () => {
      for (const projectId of [...jobs.keys()]) void cancel(projectId);
    },
  };
}
