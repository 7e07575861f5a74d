import * as z from 'zod';

// The page's policy forbids eval, and zod would try it out.
z.config({ jitless: true });
