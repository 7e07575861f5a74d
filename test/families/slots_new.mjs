// What changed between 0.180 and 0.187.
import { chunk } from './edits.mjs';

const PHYSICAL = chunk('lights_physical_pars_fragment');
const SETUP = chunk('lights_physical_fragment');
const BEGIN = chunk('lights_fragment_begin');
const PREFILTER = 'src/extras/PMREMGenerator.js';
const LOADER = 'examples/jsm/loaders/GLTFLoader.js';

/** @type {import('./slots.mjs').Border[]} */
export const NEW_BORDERS = [
  {
    older: '0.180.0',
    newer: '0.181.2',
    slots: [
      { slot: 'environment prefilter', edits: [{ file: PREFILTER, of: '0.180.0' }], cases: ['env-studio', 'env-lamps', 'background-blur'] },
      {
        slot: 'reflection direction',
        edits: [{ file: chunk('envmap_physical_pars_fragment'), replace: [['pow4( roughness )', 'roughness * roughness']] }],
        cases: ['env-studio', 'env-lamps'],
      },
      {
        slot: 'DFG',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              [
                { from: 'vec2 DFGApprox(', to: 'vec3 EnvironmentBRDF(' },
                { of: '0.180.0', from: 'vec2 DFGApprox(', to: 'vec3 EnvironmentBRDF(' },
              ],
            ],
          },
        ],
        cases: ['env-studio', 'clearcoat-env', 'transmission', 'light-directional'],
      },
      {
        slot: 'direct multiple scattering',
        edits: [{ file: PHYSICAL, replace: [['irradiance * BRDF_GGX_Multiscatter(', 'irradiance * BRDF_GGX(']] }],
        cases: ['light-directional', 'light-point', 'light-spot', 'default-material'],
      },
    ],
  },
  {
    older: '0.181.0',
    newer: '0.181.1',
    everyCase: true,
    slots: [{ slot: 'environment prefilter', edits: [{ file: PREFILTER, of: '0.181.0' }], cases: ['env-studio'] }],
  },
  {
    older: '0.181.1',
    newer: '0.181.2',
    everyCase: true,
    slots: [{ slot: 'environment prefilter', edits: [{ file: PREFILTER, of: '0.181.1' }], cases: ['env-furnace'] }],
  },
  {
    older: '0.181.2',
    newer: '0.182.0',
    slots: [
      {
        slot: 'environment prefilter',
        edits: [{ file: PREFILTER, replace: [['0.0 + targetRoughness * 1.25', '0.05 + targetRoughness * 0.95']] }],
        cases: ['env-studio', 'env-lamps', 'background-blur'],
      },
      {
        slot: 'DFG',
        edits: [{ file: 'src/renderers/shaders/DFGLUTData.js', of: '0.181.2' }],
        cases: ['env-studio', 'clearcoat-env', 'transmission', 'light-directional'],
      },
      {
        slot: 'direct multiple scattering',
        edits: [{ file: PHYSICAL, replace: [['Ems_V * Ems_L * Favg + EPSILON', 'Ems_V * Ems_L * Favg * Favg + EPSILON']] }],
        cases: ['light-directional'],
      },
      {
        slot: 'sheen albedo',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              [
                { from: 'float IBLSheenBRDF(', to: 'vec3 EnvironmentBRDF(' },
                { of: '0.181.2', from: 'float IBLSheenBRDF(', to: '// DFG LUT sampling' },
              ],
              [
                'material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI',
                'material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness )',
              ],
            ],
          },
          { file: SETUP, replace: [['clamp( sheenRoughness, 0.0001, 1.0 )', 'clamp( sheenRoughness, 0.07, 1.0 )']] },
        ],
        cases: ['sheen-env', 'sheen-sun', 'sheen-white-base-env'],
      },
      {
        slot: 'sheen energy',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              ['irradiance *= sheenEnergyComp;', ''],
              ['diffuse *= sheenEnergyComp;', ''],
              ['indirectSpecular *= sheenEnergyComp;', ''],
              ['indirectDiffuse *= sheenEnergyComp;', ''],
            ],
          },
          {
            file: 'src/renderers/shaders/ShaderLib/meshphysical.glsl.js',
            replace: [
              [
                'outgoingLight = outgoingLight + sheenSpecularDirect',
                'outgoingLight = outgoingLight * ( 1.0 - 0.157 * max3( material.sheenColor ) ) + sheenSpecularDirect',
              ],
            ],
          },
        ],
        cases: ['sheen-env', 'sheen-sun', 'sheen-hemisphere'],
      },
      {
        slot: 'environment by metalness',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              [
                'computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor,',
                'computeMultiscattering( geometryNormal, geometryViewDir, material.specularColorBlended,',
              ],
              [
                'computeMultiscattering( geometryNormal, geometryViewDir, material.diffuseColor,',
                'computeMultiscattering( geometryNormal, geometryViewDir, material.specularColorBlended,',
              ],
              [
                'computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor,',
                'computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColorBlended,',
              ],
              [
                'computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.diffuseColor,',
                'computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColorBlended,',
              ],
              ['( 1.0 - totalScatteringDielectric )', '( 1.0 - max3( totalScatteringDielectric ) )'],
            ],
          },
        ],
        cases: ['env-studio', 'specular-env', 'everything'],
      },
      {
        slot: 'iridescence by metalness',
        edits: [
          {
            file: BEGIN,
            replace: [
              [
                'mix( material.iridescenceFresnelDielectric, material.iridescenceFresnelMetallic, material.metalness )',
                'evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColorBlended )',
              ],
            ],
          },
          {
            file: PHYSICAL,
            replace: [
              ['material.iridescence, material.iridescenceFresnelDielectric,', 'material.iridescence, material.iridescenceFresnel,'],
              ['material.iridescence, material.iridescenceFresnelMetallic,', 'material.iridescence, material.iridescenceFresnel,'],
            ],
          },
        ],
        cases: ['everything'],
      },
      { slot: 'anisotropic visibility', edits: [{ file: PHYSICAL, replace: [['return v;', 'return saturate( v );']] }], cases: ['anisotropy-sun'] },
      {
        slot: 'shadow filter',
        edits: [
          ...[
            'src/renderers/webgl/WebGLShadowMap.js',
            'src/renderers/webgl/WebGLLights.js',
            'src/lights/PointLightShadow.js',
            'src/lights/LightShadow.js',
            'src/renderers/shaders/ShaderLib.js',
            'src/renderers/shaders/ShaderLib/distanceRGBA.glsl.js',
            'src/renderers/shaders/ShaderLib/depth.glsl.js',
            'src/renderers/shaders/ShaderLib/vsm.glsl.js',
            'src/renderers/shaders/ShaderChunk.js',
            chunk('shadowmap_pars_fragment'),
            'src/renderers/webgl/WebGLProgram.js',
          ].map((file) => ({ file, of: '0.181.2' })),
          { file: 'src/renderers/webgl/WebGLPrograms.js', replace: [["MeshDistanceMaterial: 'distance'", "MeshDistanceMaterial: 'distanceRGBA'"]] },
          {
            file: 'src/renderers/shaders/ShaderLib/meshphysical.glsl.js',
            replace: [['#include <dithering_pars_fragment>', '#include <packing>\n#include <dithering_pars_fragment>']],
          },
          {
            file: 'src/renderers/shaders/ShaderLib/shadow.glsl.js',
            replace: [['#include <fog_pars_fragment>', '#include <packing>\n#include <fog_pars_fragment>']],
          },
        ],
        cases: ['shadow-directional', 'shadow-spot', 'shadow-point', 'shadow-pcf-soft', 'shadow-vsm', 'shadow-point-basic', 'ground'],
      },
    ],
  },
  {
    older: '0.182.0',
    newer: '0.183.2',
    slots: [
      {
        slot: 'rect light, F90',
        edits: [
          {
            file: PHYSICAL,
            replace: [['( material.specularF90 - material.specularColorBlended ) * t2.y', '( vec3( 1.0 ) - material.specularColorBlended ) * t2.y']],
          },
        ],
        cases: ['rect-specular'],
      },
      {
        slot: 'rect light on the coat',
        edits: [
          {
            file: PHYSICAL,
            replace: [['clearcoatSpecularDirect += lightColor * fresnelClearcoat', 'if ( false ) clearcoatSpecularDirect += lightColor * fresnelClearcoat']],
          },
        ],
        cases: ['rect-clearcoat'],
      },
      {
        slot: 'soft shadows',
        edits: [{ file: 'src/renderers/webgl/WebGLShadowMap.js', replace: [['this.type = PCFShadowMap;', '']] }],
        cases: ['shadow-pcf-soft'],
      },
    ],
  },
  {
    older: '0.183.2',
    newer: '0.184.0',
    slots: [
      { slot: 'ior 0', edits: [{ file: LOADER, replace: [['if ( materialParams.ior === 0 ) materialParams.ior = 1000;', '']] }], cases: ['ior-0-hemisphere'] },
      {
        slot: 'anisotropic visibility',
        edits: [
          {
            file: PHYSICAL,
            replace: [['0.5 / max( gv + gl, EPSILON );\n\n\t}\n\n\tfloat D_GGX_Anisotropic', '0.5 / ( gv + gl );\n\n\t}\n\n\tfloat D_GGX_Anisotropic']],
          },
        ],
        cases: ['everything'],
      },
      { slot: 'normal offset of shadows', edits: [{ file: chunk('shadowmap_vertex'), of: '0.183.2' }], cases: ['shadow-directional', 'shadow-pcf-soft'] },
    ],
  },
  {
    older: '0.185.1',
    newer: '0.186.1',
    slots: [
      {
        slot: 'direct multiple scattering',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              [
                'void RE_Direct_Physical(',
                [{ of: '0.185.1', from: 'vec3 BRDF_GGX_Multiscatter(', to: '#if NUM_RECT_AREA_LIGHTS' }, 'void RE_Direct_Physical('],
              ],
              [
                'irradiance * specularBRDF * material.multiScatteringCompensation',
                'irradiance * BRDF_GGX_Multiscatter( directLight.direction, geometryViewDir, geometryNormal, material )',
              ],
            ],
          },
        ],
        cases: ['light-directional', 'light-point', 'default-material'],
      },
      {
        slot: 'diffuse under direct light',
        edits: [{ file: PHYSICAL, replace: [['BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - F )', 'BRDF_Lambert( material.diffuseContribution )']] }],
        cases: ['light-directional', 'base-color-map'],
      },
      {
        slot: 'diffuse under ambient light',
        edits: [
          {
            file: PHYSICAL,
            replace: [
              ['BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering )', 'BRDF_Lambert( material.diffuseContribution )'],
            ],
          },
        ],
        cases: ['light-ambient', 'light-hemisphere'],
      },
      {
        slot: 'sheen under ambient light',
        edits: [{ file: PHYSICAL, replace: [['sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;', '']] }],
        cases: ['sheen-hemisphere'],
      },
      {
        slot: 'iridescence in the environment',
        edits: [
          {
            file: BEGIN,
            replace: [
              ['Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi )', 'iridescenceFresnelDielectric'],
              ['Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi )', 'iridescenceFresnelMetallic'],
            ],
          },
        ],
        cases: ['iridescence-env', 'iridescence-metal-env'],
      },
      { slot: 'environment prefilter', edits: [{ file: PREFILTER, of: '0.185.1' }], cases: ['env-studio', 'env-lamps', 'background-blur'] },
      { slot: 'texture transform', edits: [{ file: LOADER, replace: [['texture.matrixAutoUpdate = false;', '']] }], cases: ['texture-transform'] },
    ],
  },
  {
    older: '0.186.1',
    newer: '0.187.0',
    slots: [
      {
        slot: 'environment prefilter',
        edits: [
          PREFILTER,
          'src/constants.js',
          'src/Three.js',
          'src/renderers/webgl/WebGLProgram.js',
          'src/renderers/webgl/WebGLPrograms.js',
          'src/renderers/webgl/WebGLEnvironments.js',
          'src/renderers/webgl/WebGLBackground.js',
          'src/renderers/shaders/ShaderChunk.js',
          chunk('cube_uv_reflection_fragment'),
          chunk('envmap_common_pars_fragment'),
          chunk('envmap_physical_pars_fragment'),
          chunk('lights_fragment_maps'),
          chunk('lightprobes_pars_fragment'),
          chunk('lights_fragment_begin'),
          'src/renderers/shaders/ShaderLib/backgroundCube.glsl.js',
          'src/renderers/shaders/ShaderLib/meshphysical.glsl.js',
          'src/renderers/shaders/ShaderLib/meshlambert.glsl.js',
          'src/renderers/shaders/ShaderLib/meshphong.glsl.js',
        ].map((file) => ({ file, of: '0.186.1' })),
        cases: ['env-studio', 'env-lamps', 'env-intensity', 'background-blur', 'background-env'],
      },
      {
        slot: 'least roughness',
        edits: [
          {
            file: SETUP,
            replace: [
              ['max( roughnessFactor, 0.045 )', 'max( roughnessFactor, 0.0525 )'],
              ['max( material.clearcoatRoughness, 0.045 )', 'max( material.clearcoatRoughness, 0.0525 )'],
            ],
          },
        ],
        cases: ['light-directional', 'env-lamps', 'clearcoat-sun'],
      },
      {
        slot: 'diffuse roughness',
        edits: [{ file: LOADER, replace: [['materialParams.diffuseRoughness = ', 'const unused = ']] }],
        cases: ['diffuse-roughness-sun', 'diffuse-roughness-env'],
      },
      {
        slot: 'shadows of point lights',
        edits: [
          {
            file: chunk('shadowmap_pars_fragment'),
            replace: [
              [
                'float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );',
                'float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) ) + shadowBias;',
              ],
            ],
          },
        ],
        cases: ['shadow-point'],
      },
    ],
  },
];
