import { closeSync, openSync, readFileSync, writeSync } from 'node:fs';
import os from 'node:os';

// Where Linux shares the CPU out among sessions first (sched(7), autogroup), priorities of processes count within one session alone.
// So the session of a worker has the lower priority, too.

/** The kernel takes one such change in 100 ms from all who are not root; the others are told to come again. */
const AGAIN_MS = 110;
const TRIES = 100;

/** @param {string} text of /proc/PID/autogroup. Empty: of a process that was in no session of its own when it was made, as the first of a container */
export const niceOfSession = (text) => Number(/nice (-?\d+)/.exec(text)?.[1] ?? 0);

/** Gives the session of this process `nicer` more than the one of process `ofPid` has. It does nothing on a kernel without autogroups. */
export function lowerSession(nicer, ofPid) {
  let file;
  try {
    const nice = niceOfSession(readFileSync(`/proc/${ofPid}/autogroup`, 'latin1')) + nicer;
    // Opened now: a worker may open no file once it draws.
    file = openSync('/proc/self/autogroup', 'w');
    write(file, String(Math.min(os.constants.priority.PRIORITY_LOW, nice)), TRIES);
  } catch {
    if (file !== undefined) closeSync(file);
  }
}

function write(file, text, tries) {
  try {
    writeSync(file, text);
  } catch (error) {
    if (error.code === 'EAGAIN' && tries > 1) return void setTimeout(write, AGAIN_MS, file, text, tries - 1).unref();
  }
  closeSync(file);
}
