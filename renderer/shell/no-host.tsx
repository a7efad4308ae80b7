import './no-host.css';
import { Logo } from './logo.tsx';

/** The page was opened from an address without the launch's token. */
export function NoHost() {
  return (
    <main className="no-host">
      <Logo />
      <h1>This address is not complete</h1>
      <p>Open the one that Scrim printed when it was started. It ends in a token that lets only you in.</p>
    </main>
  );
}
