% What probes read of a shaft that runs out, beside the response that is compensated for it.
lines = {'whirl: 1', 'rotor:', '  speed: 100 rad/s', '  length_scale: 0.1 mm', '  stations:', ...
         '    disc: {mass: 2 kg, eccentricity: 20 um, eccentricity_angle: 0.3}', '  elements:', ...
         '    - spring: {between: [disc, ground], stiffness: 50 kN/m, damping: 60 N.s/m}', ...
         '    - runout: {at: disc, amplitude: 3 um, angle: 0.5}', 'study: {unbalance: {}}', ''};
text = strjoin(lines, char(10));
result = whirl_run(text, 'progress', false, 'threads', 1);
response = result.unbalance.unbalance;
own = response.probe(:) .* exp(-1i * pi / 180 * response.probe_lag(:));
seen = response.seen(:) .* exp(-1i * pi / 180 * response.seen_lag(:));
exact = 2 * 2e-5 * 100^2 / (5e4 - 2 * 100^2 + 60i * 100) * exp(0.3i) / 1e-4;
assert(own, exact * [1; -1i], 1e-12);
assert(seen - own, 0.03 * exp(0.5i) * [1; -1i], 1e-12);
disp('all well');
