% What whirl_run and whirl_read give is what h5py reads in the result file, to the bit; errors are sentences.
function wrong(call, identifier, part)
  try
    call();
  catch problem
    assert(problem.identifier, identifier);
    assert(~isempty(strfind(problem.message, part)), problem.message);
    return
  end
  error('no error: %s', func2str(call));
end

good = fileread([getenv('TESTS') '/cli/good.yaml']);
result = whirl_run(good, 'kappa', 0.1 + 0.2, 'output', 'a.h5', 'progress', false, 'threads', 1);
% A result that is there is kept, unless it is to be replaced.
before = dir('a.h5');
try
  whirl_run(good, 'output', 'a.h5', 'progress', false);
  error('no error');
catch problem
  assert(~isempty(strfind(problem.message, 'is kept: ''overwrite'', true replaces it')), problem.message);
end
assert(isequal(before, dir('a.h5')));
for given = {{'output', 3}, {'overwrite', 'yes'}, {'progress', 'no'}, {'threads', 'all'}}
  try
    whirl_run(good, given{1}{:});
    error('no error');
  catch problem
    assert(problem.identifier, 'whirl:badInput');
    assert(~isempty(strfind(problem.message, ['''' given{1}{1} ''' takes'])), problem.message);
  end
end
result = whirl_run(good, 'kappa', 0.1 + 0.2, 'output', 'a.h5', 'overwrite', true, 'progress', false, 'threads', 1);
again = whirl_read('a.h5');
assert(isequaln(result, again));
assert(result.parameters.value(2), 0.1 + 0.2);
assert(size(result.sweep.poincare.section), [5 1 10 4]);
assert(result.sweep.attributes.parameter, 'omega');
assert(result.sweep.orbit.about.max_radius.unit, 'length');
assert(iscellstr(result.sweep.verdict.name) && numel(result.sweep.verdict.name) == 5);

% The bytes of arrays, the point first, beside h5py's.
section = permute(result.sweep.poincare.section, [4 3 2 1]);   % C order
stream = fopen('section.bin', 'w');
fwrite(stream, section, 'double');
fwrite(stream, result.sweep.values, 'double');
fwrite(stream, result.sweep.regime.confidence, 'double');
fwrite(stream, result.sweep.point, 'int64');
fclose(stream);
code = ['import h5py; f = h5py.File("a.h5")["sweep"]; ' ...
        'b = b"".join(f[n][()].tobytes() for n in ("poincare/section", "values", "regime/confidence", "point")); ' ...
        'assert len(b) > 1700 and b == open("section.bin", "rb").read(), "other bytes"'];
assert(system([getenv('PYTHON') ' -c ''' code '''']), 0);

% A case in a file whose name needs quotes; a result that is not kept.
stream = fopen('it''s $(a) case.yaml', 'w');
fwrite(stream, good);
fclose(stream);
named = whirl_run('it''s $(a) case.yaml', 'progress', false);
assert(named.sweep.values, result.sweep.values);

% A name that begins with - is no option.
stream = fopen('-case.yaml', 'w');
fwrite(stream, good);
fclose(stream);
named = whirl_run('-case.yaml', 'output', '-r.h5', 'progress', false);
assert(isequaln(whirl_read('-r.h5').sweep.values, named.sweep.values));

wrong(@() whirl_run(good, 'kapa', 3, 'progress', false), 'whirl:badInput', 'kappa');
wrong(@() whirl_run('nowhere.yaml', 'progress', false), 'whirl:badInput', 'nowhere.yaml');
wrong(@() whirl_run(good, 'kappa'), 'whirl:badInput', 'pairs');
wrong(@() whirl_run(good, 'kappa', [1 2]), 'whirl:badInput', 'neither a number nor a text');
wrong(@() whirl_read('nowhere.h5'), 'whirl:badInput', 'nowhere.h5');
wrong(@() whirl_read(3), 'whirl:badInput', 'name of a file');
wrong(@() whirl_plot_map(result), 'whirl:badInput', 'no such map');
wrong(@() whirl_plot_orbit(result), 'whirl:badInput', 'waveform');
setenv('WHIRL', 'no-such-command');
wrong(@() whirl_read('a.h5'), 'whirl:noCommand', 'setenv');
disp('all well');
