import { main } from './main.mjs';
import { THUMBNAIL } from './thumbnail_command.mjs';

// `telar thumbnail` alone, for js/build/dist.mjs: what it has no use for is not read when a picture is waited for.
void main({ thumbnail: THUMBNAIL });
