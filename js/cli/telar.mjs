#!/usr/bin/env node
import { COMMANDS } from './commands.mjs';
import { main } from './main.mjs';

void main(COMMANDS);
