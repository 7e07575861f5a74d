// A polished relief: flat facets, as sequins are, and the edges between them have a highlight each. Of all slopes one lobe would be
// too dull for the facets. Shared text: see README.md.
// src: Han et al. 2007, "Frequency Domain Normal Map Filtering", for mixtures of lobes

// Share of a texel that counts as facet, [FACET_SHARE_MIN, 1].   slope2  square of its slope
float facetShare(float slope2) { return max(1.0 / (1.0 + pow2(slope2 / FACET_SLOPE2)), FACET_SHARE_MIN); }

// Share of a pixel that is edges, [0, 1].
// share  mean of facetShare() over its texels      slope2  mean square of slopes, weighted by it
float edgeShare(float share, float slope2) { return 1.0 - saturate(share / facetShare(slope2)); }
