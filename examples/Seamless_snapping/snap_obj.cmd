data/genus3_features.obj snapped.obj --features --align-border
