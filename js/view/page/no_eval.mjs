import * as z from '../../dist/zod.mjs';

// The page's policy forbids eval, and zod would try it out.
z.config({ jitless: true });
