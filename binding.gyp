# Forwards to CMake (js/build/addon.mjs): sources and flags stand in CMakeLists.txt alone.
{
  'targets': [{
    'target_name': 'telar',
    'type': 'none',
    'actions': [{
      'action_name': 'cmake',
      'inputs': [],
      # Never written, so the action always runs: ninja decides what is stale.
      'outputs': ['<(INTERMEDIATE_DIR)/always'],
      'action': ['node', '<(module_root_dir)/js/build/addon.mjs'],
      'message': 'Building out/release/addon/telar.node with CMake',
    }],
  }],
}
