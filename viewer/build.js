// Writes the bundles.

import { build } from "esbuild";
import { BUNDLES } from "./bundle_options.js";

for (const options of BUNDLES) await build({ ...options, logLevel: "info" });
