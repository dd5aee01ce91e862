// Exported glTF files against the validator of the Khronos Group (npm package gltf-validator; NODE_PATH says where).
// validate_gltf.js KNITTSIM_CLI PATTERN...
const { execFileSync } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

let validator;
try {
    validator = require('gltf-validator');
} catch (error) {
    console.error('There is no gltf-validator; skipped.');
    process.exit(77);
}

async function problemsOf(file) {
    const beside = uri => Promise.resolve(new Uint8Array(fs.readFileSync(path.join(path.dirname(file), uri))));
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
                                                 { uri: path.basename(file), externalResourceFunction: beside });
    console.log(`${path.basename(file)}: ${report.info.totalTriangleCount} triangles`);
    const bad = report.issues.numErrors + report.issues.numWarnings;
    return bad > 0 || report.info.totalTriangleCount === 0 ? [file, ...report.issues.messages] : [];
}

async function main([cli, ...patterns]) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'knittsim-gltf-'));
    const problems = [];
    try {
        for (const pattern of patterns) {
            for (const extension of ['gltf', 'glb']) {
                const file = path.join(folder, `${path.basename(pattern, '.k')}.${extension}`);
                execFileSync(cli, ['export', pattern, '-o', file]);
                problems.push(...await problemsOf(file));
            }
        }
    } finally {
        fs.rmSync(folder, { recursive: true });
    }
    problems.forEach(problem => console.error(problem));
    process.exitCode = problems.length > 0 ? 1 : 0;
}

main(process.argv.slice(2));
