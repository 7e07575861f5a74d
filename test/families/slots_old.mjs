// What changed between 0.150 and 0.165.
import { chunk } from './edits.mjs';

const SETUP = chunk('lights_physical_fragment');
const PREFILTER = 'src/extras/PMREMGenerator.js';
const RENDERER = 'src/renderers/WebGLRenderer.js';
const TONES = chunk('tonemapping_pars_fragment');
const LOADER = 'examples/jsm/loaders/GLTFLoader.js';

/** Maps in the order in which 0.150 looks for the one whose transform all of them have. */
const MAPS = [
  'map',
  'specularMap',
  'displacementMap',
  'normalMap',
  'bumpMap',
  'roughnessMap',
  'metalnessMap',
  'alphaMap',
  'emissiveMap',
  'clearcoatMap',
  'clearcoatNormalMap',
  'clearcoatRoughnessMap',
  'iridescenceMap',
  'iridescenceThicknessMap',
  'specularIntensityMap',
  'specularColorMap',
  'transmissionMap',
  'thicknessMap',
  'sheenColorMap',
  'sheenRoughnessMap',
];
const ONE_TRANSFORM = [
  {
    file: 'src/renderers/webgl/WebGLMaterials.js',
    replace: [
      [
        'function refreshTransformUniform(',
        `const firstMap = ( material ) => ${JSON.stringify(MAPS)}.map( ( name ) => material[ name ] ).find( Boolean );\nfunction refreshTransformUniform(`,
      ],
      ...MAPS.map((name) => [`refreshTransformUniform( material.${name},`, 'refreshTransformUniform( firstMap( material ),']),
    ],
  },
  // The loader knows the second coordinates for occlusion alone, which reads them always.
  {
    file: LOADER,
    of: '0.150.1',
    replace: [
      [
        'materialParams[ mapName ] = texture;',
        "if ( mapName === 'aoMap' ) { texture = texture.clone(); texture.channel = 1; }\nmaterialParams[ mapName ] = texture;",
      ],
    ],
  },
];

/** @type {import('./slots.mjs').Border[]} */
export const OLD_BORDERS = [
  {
    older: '0.150.1',
    newer: '0.151.3',
    slots: [
      {
        slot: 'back sides behind glass',
        edits: [{ file: RENDERER, replace: [['if ( material.side === DoubleSide && object.layers.test( camera.layers ) ) {', 'if ( false ) {']] }],
        cases: ['transmission-two-sided', 'transmission-color', 'transmission-tone'],
      },
      { slot: 'texture coordinates', edits: ONE_TRANSFORM, cases: ['texture-transform', 'two-uv-sets', 'everything'] },
    ],
  },
  {
    older: '0.152.2',
    newer: '0.153.0',
    slots: [
      {
        slot: 'anisotropy direction',
        edits: [{ file: LOADER, replace: [['materialParams.anisotropy = ', 'const unused = ']] }],
        cases: ['anisotropy-sun', 'anisotropy-env', 'everything'],
      },
      {
        slot: 'buffer behind glass',
        edits: [
          {
            file: RENDERER,
            replace: [
              ['_transmissionRenderTarget.setSize( _vector2.x, _vector2.y )', '_transmissionRenderTarget.setSize( 1024, 1024 )'],
              ['if ( _currentClearAlpha < 1 ) _this.setClearColor( 0xffffff, 0.5 );', ''],
            ],
          },
        ],
        cases: ['transmission', 'transmission-volume', 'transmission-color'],
      },
      {
        slot: 'alpha of glass',
        edits: [
          { file: chunk('output_fragment'), replace: [['material.transmissionAlpha;', 'material.transmissionAlpha + 0.1;']] },
          { file: chunk('transmission_pars_fragment'), replace: [['1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor', 'transmittedLight.a']] },
        ],
        cases: ['transmission', 'transmission-volume'],
      },
    ],
  },
  {
    older: '0.157.0',
    newer: '0.158.0',
    slots: [
      {
        slot: 'occlusion of coat and sheen',
        edits: [
          {
            file: chunk('aomap_fragment'),
            replace: [
              ['clearcoatSpecularIndirect *= ambientOcclusion;', ''],
              ['sheenSpecularIndirect *= ambientOcclusion;', ''],
            ],
          },
        ],
        cases: ['everything', 'cloth'],
      },
    ],
  },
  {
    older: '0.158.0',
    newer: '0.159.0',
    slots: [
      {
        slot: 'anisotropy direction',
        edits: [
          {
            file: SETUP,
            replace: [
              ['tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y', 'tbn[ 0 ] * anisotropyV.x - tbn[ 1 ] * anisotropyV.y'],
              ['tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y', 'tbn[ 1 ] * anisotropyV.x + tbn[ 0 ] * anisotropyV.y'],
            ],
          },
        ],
        cases: ['anisotropy-sun', 'anisotropy-env', 'everything'],
      },
    ],
  },
  {
    older: '0.160.1',
    newer: '0.161.0',
    slots: [
      {
        slot: 'precision of samplers',
        edits: [
          {
            file: 'src/renderers/webgl/WebGLProgram.js',
            replace: [['precision ${parameters.precision} sampler2D;\n\tprecision ${parameters.precision} samplerCube;', '']],
          },
        ],
        cases: ['env-studio', 'base-color-map', 'light-rect', 'shadow-spot', 'shadow-vsm'],
      },
      {
        slot: 'background cube',
        edits: [
          {
            file: 'src/renderers/webgl/WebGLCubeMaps.js',
            replace: [['new WebGLCubeRenderTarget( image.height )', 'new WebGLCubeRenderTarget( image.height / 2 )']],
          },
        ],
        cases: ['background-env', 'transmission-tone'],
      },
    ],
  },
  {
    older: '0.162.0',
    newer: '0.163.0',
    slots: [
      { slot: 'shadows of point lights', edits: [{ file: chunk('shadowmap_pars_fragment'), of: '0.162.0' }], cases: ['shadow-point', 'shadow-point-basic'] },
      { slot: 'tone mapping neutral', edits: [{ file: TONES, replace: [['newPeak * vec3(1, 1, 1)', 'vec3(1, 1, 1)']] }], cases: ['tone-neutral'] },
    ],
  },
  {
    older: '0.163.0',
    newer: '0.164.1',
    slots: [
      { slot: 'environment prefilter', edits: [{ file: PREFILTER, of: '0.163.0' }], cases: ['env-studio', 'env-lamps', 'background-blur', 'transmission'] },
      { slot: 'dispersion', edits: [{ file: LOADER, replace: [['materialParams.dispersion = ', 'const unused = ']] }], cases: ['transmission-dispersion'] },
    ],
  },
  {
    older: '0.164.1',
    newer: '0.165.0',
    slots: [
      {
        slot: 'transmission over a colour',
        edits: [
          {
            file: RENDERER,
            replace: [['if ( _renderBackground ) {\n\n\t\t\t\tbackground.render( scene );', 'if ( false ) {\n\n\t\t\t\tbackground.render( scene );']],
          },
        ],
        cases: ['transmission-color'],
      },
    ],
  },
];
