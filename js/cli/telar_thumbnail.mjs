import { earlyRenderer } from './early_renderer.mjs';
import { main } from './main.mjs';
import { THUMBNAIL } from './thumbnail_command.mjs';

// js/build/dist.mjs bundles this for `telar thumbnail`, so that Node reads less.
void main({ thumbnail: THUMBNAIL }, earlyRenderer);
