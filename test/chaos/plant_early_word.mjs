import { register } from 'node:module';

// A planted fault: a worker says that a job is done before its result is stored. node --import plant_early_word.mjs ...

register(new URL('early_word_hooks.mjs', import.meta.url));
