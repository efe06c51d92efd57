% What was put in comes out: a disc on a spring, from columns and from a table; bad input has the command's sentences.
function wrong(call, part)
  try
    call();
  catch problem
    assert(problem.identifier, 'whirl:badInput');
    assert(~isempty(strfind(problem.message, part)), problem.message);
    return
  end
  error('no error: %s', func2str(call));
end
machine = sprintf('%s\n', 'whirl: 1', 'title: A disc', ...
  'parameters: {n: 100 rad/s, k: 30 kN/m, c: 52 N s/m, e: 50 um}', 'rotor:', '  speed: = n', '  length_scale: 1 mm', ...
  '  stations: {disc: {mass: 3 kg, damping: = c, eccentricity: = e}}', '  elements:', ...
  '    - shaft: {between: [disc, ground], k1: = k}', 'study:', '  # replaced', '  response: {}');
w = (60:10:140)';
response = 38e-6 * w.^2 ./ (33e3 / 3 - w.^2 + 1i * 52 * w / 3);
data = {'speed [rad/s]', w, 'disc x [m]', abs(response), 'disc x lag [rad]', -angle(response)};
found = whirl_fit(machine, data, struct('k', [10e3 90e3], 'e', []), 'tolerance', 1e-10, 'noise', 1e-6, 'profile', true);
assert([found.k.value found.e.value], [33e3 38e-6], -1e-8);
assert(found.k.known, 'determined');
assert(found.k.profile, [found.k.low found.k.high], 0.01 * (found.k.high - found.k.low));
% A file of Octave's own in HDF5, whose variables are groups with a dataset, gives the same.
sizes = abs(response);
lags = -angle(response);
save('-hdf5', 'bode.h5', 'w', 'sizes', 'lags');
columns = {'speed [rad/s]', 'w/value', 'disc x [m]', 'sizes/value', 'disc x lag [rad]', 'lags/value'};
again = whirl_fit(machine, 'bode.h5', struct('k', [10e3 90e3], 'e', []), 'tolerance', 1e-10, 'columns', columns);
assert([again.k.value again.e.value], [33e3 38e-6], -1e-8);
wrong(@() whirl_fit(machine, 'bode.h5', struct('k', []), 'record', 3), 'is no data set, which study: dataset makes');
% So do MAT files of all versions, and members of a structure.
bode.w = w;
bode.sizes = sizes;
bode.lags = lags;
columns = {'speed [rad/s]', 'w', 'disc x [m]', 'sizes', 'disc x lag [rad]', 'lags'};
for version = {'-v4', '-v6', '-v7'}
  save(version{1}, 'bode.mat', 'w', 'sizes', 'lags');
  again = whirl_fit(machine, 'bode.mat', struct('k', [10e3 90e3], 'e', []), 'tolerance', 1e-10, 'columns', columns);
  assert([again.k.value again.e.value], [33e3 38e-6], -1e-8);
end
save('-v7', 'bode.mat', 'bode');
columns = {'speed [rad/s]', 'bode.w', 'disc x [m]', 'bode.sizes', 'disc x lag [rad]', 'bode.lags'};
again = whirl_fit(machine, 'bode.mat', struct('k', [10e3 90e3], 'e', []), 'tolerance', 1e-10, 'columns', columns);
assert([again.k.value again.e.value], [33e3 38e-6], -1e-8);
file = fopen('bode.csv', 'w');
fprintf(file, 'speed [rad/s], disc x [m], disc x lag [rad]\n');
fprintf(file, '%.17g, %.17g, %.17g\n', [w abs(response) -angle(response)]');
fclose(file);
again = whirl_fit(machine, 'bode.csv', struct('k', [10e3 90e3], 'e', []), 'tolerance', 1e-10, 'noise', '1 um');
assert(again.k.value, found.k.value, -1e-12);
assert(isnan(again.k.profile));
% The critical speed and the damping ratio of an undamped frequency w0: w = w0 sqrt(1 - z^2), z = c/(2 m w0).
w0 = sqrt(33e3 / 3);
z = 45 / (6 * w0);
numbers = {struct('critical', sprintf('%.17g rad/s', w0 * sqrt(1 - z^2)), 'whirl', 'forward', 'noise', '1 rad/s'), ...
           struct('damping', z, 'mode', 1, 'noise', 0.001)};
fitted = whirl_fit(machine, numbers, struct('k', [], 'c', []), 'tolerance', 1e-10);
assert([fitted.k.value fitted.c.value], [33e3 45], -1e-8);
lost = whirl_fit(machine, struct('onset', '100 rad/s', 'noise', '1 rad/s'), struct('c', []));
assert(lost.c.known, 'unknown');
wrong(@() whirl_fit(machine, numbers{1}, struct('k', []), 'noise', '1 um'), 'belongs to a table');
critical = struct('critical', '104 rad/s', 'noise', '1 rad/s');
one = whirl_fit(machine, critical, struct('k', [10e3 90e3]), 'profile', true);
assert(one.k.value > 32e3 && one.k.profile(1) < one.k.value && one.k.profile(2) > one.k.value);
% So slow a run has the steady motions, to some 1e-3.
run = struct('speed_from', '50 rad/s', 'speed_to', '150 rad/s', 'rate', '0.5 rad/s2', 'begin', 'steady');
slow = whirl_fit(machine, data, struct('k', [10e3 90e3], 'e', []), 'noise', 1e-6, 'runup', run);
assert([slow.k.value slow.e.value], [33e3 38e-6], -5e-3);
endless = struct('rate', '1 rad/s2');
wrong(@() whirl_fit(machine, data, struct('k', []), 'runup', endless), 'the run has a rate and no end');
wrong(@() whirl_fit(machine, 'gone.csv', struct('k', [])), 'gone.csv');
wrong(@() whirl_fit(machine, data, struct('kk', [])), 'kk');
wrong(@() whirl_fit(machine, data, 'k'), 'whirl_fit takes a case');
disp('all well');
