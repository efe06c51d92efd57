% Signals of a data set: those of a balanced machine that does not move, and of an unbalanced one by its closed form.
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
lines = {'whirl: 1', 'parameters: {e: 0 m}', 'rotor:', '  speed: 0.5 rad/s', '  length_scale: 1 m', '  stations:', ...
         '    disc: {mass: 1 kg, damping: 0.2 N s/m, eccentricity: = e}', '  elements:', ...
         '    - shaft: {between: [disc, ground], k1: 1 N/m}', 'study:', '  dataset:', '    machines: 3', ...
         '    samples_per_revolution: 16', '    revolutions: 8', '    labels:', '      healthy:', ...
         '      unbalance: {grade: {e: {from: 0.1 m, to: 0.4 m}}}', '    channels:', ...
         '      - {sensor: proximity, at: disc, gap: 2 m, sensitivity: 3 V/m}', ...
         '      - {sensor: proximity, at: disc, angle: 90 deg}', '  integrate: {transient: 60}', ...
         '  analyze: [orbit, regime]'};
result = whirl_run(sprintf('%s\n', lines{:}), 'output', 'records.h5', 'progress', false);
assert(whirl_signals('records.h5', 'size'), [6, 2, 128]);
every = whirl_signals('records.h5');
assert(class(every), 'single');
assert(size(every), [128, 2, 6]);
label = result.records.dataset.label;
assert(label(:)', [0, 1, 0, 1, 0, 1]);
% A healthy machine stands still at its gap; an unbalanced one turns with the amplitude of its closed form.
severity = result.records.dataset.severity;
for row = 1:6
  if label(row) == 0
    assert(every(:, 1, row), 6 * ones(128, 1, 'single'), single(1e-5));
    assert(every(:, 2, row), zeros(128, 1, 'single'), single(1e-6));
  else
    amplitude = (0.1 + 0.3 * severity(row)) * 0.25 / abs(1 - 0.25 + 0.1i);
    line = 2 / 128 * abs(sum(double(every(:, 2, row)) .* exp(-2i * pi * (0:127)' / 16)));
    assert(line, amplitude, 2e-4 * amplitude);
  end
end
% Rows in any order are the same rows.
assert(whirl_signals('records.h5', [5, 2, 3, 4, 2]), every(:, :, [5, 2, 3, 4, 2]));
assert(whirl_signals('records.h5', 4), every(:, :, 4));
assert(isempty(whirl_signals('records.h5', [])));
wrong(@() whirl_signals('records.h5', 7), 'rows from 1 to 6');
wrong(@() whirl_signals('records.h5', 0), 'rows from 1 to 6');
wrong(@() whirl_signals('records.h5', 'all'), 'or ''size''');
wrong(@() whirl_signals('nothing.h5'), 'nothing.h5');
disp('all well');
