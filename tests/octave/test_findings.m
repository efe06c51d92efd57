% Statements and tables in Octave are those of the command. A disc of 2 kg on springs of 80 and 200 kN/m.
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
speeds = sqrt([80e3; 200e3] / 2);
result = whirl_run([getenv('TESTS') '/cli/modes.yaml'], 'output', 'm.h5', 'progress', false);
sheet = whirl_table('m.h5', 'critical');
at = strcmp(sheet.keys, 'omega');
assert(sheet.matrix(:, at) * sheet.sizes(at), speeds, -1e-9);
assert(sheet.units{at}, 'rpm');
assert(sheet.cells{2, at}, speeds(2) * 30 / pi, -1e-9);
assert(sheet.cells{1, strcmp(sheet.keys, 'what')}, 'critical speed');
assert(isnan(sheet.matrix(1, strcmp(sheet.keys, 'what'))));
assert(size(sheet.cells), [2, numel(sheet.headings)]);
assert(sheet.texts(:, at), {'1909.9'; '3019.8'});
sheet = whirl_table(result, 'modes/critical', 'units', 'rad/s');
assert(sheet.units{at}, 'rad/s');
assert(sheet.matrix(:, at), speeds, -1e-9);
assert(whirl_table('m.h5', 'list'), {'stations'; 'supports'; 'critical'; 'lowest'});
statements = whirl_statements(result);
own = statements(strncmp({statements.what}, 'critical speeds', 15));
assert(own.found, '1909.9 rpm, 3019.8 rpm');
assert(own.values.found, speeds, -1e-9);
assert(own.verdict, 'none asked for');
assert(~isempty(strfind(own.text, own.found)));
assert(isempty(own.clause) && isempty(own.at) && isempty(own.values.at));
assert(isempty(strfind(whirl_statements('m.h5', 'units', 'rad/s')(strcmp({statements.what}, own.what)).found, 'rpm')));

% Every cell of a machine of many tables, and of branches, whose cells hold texts, several numbers, or nothing.
text = fileread([getenv('CASES') '/pump.yaml']);
text = regexprep(text, '\n  (motions|starts|integrate|analyze):[^\n]*', '');
text = regexprep(text, 'points: \d+', 'points: 4');
whirl_run(text, 'output', 'pump.h5', 'progress', false);
whirl_run([getenv('TESTS') '/cli/branch.yaml'], 'output', 'branch.h5', 'progress', false);
several = 0;
for file = {'pump.h5', 'branch.h5'}
  names = whirl_table(file{1}, 'list');
  for i = 1:numel(names)
    sheet = whirl_table(file{1}, names{i});
    [status, printed] = system([getenv('WHIRL') ' table ' file{1} ' ' names{i} ' --format csv']);
    assert(status, 0);
    lines = strsplit(strtrim(printed), "\r\n")(2:end);
    assert(numel(lines), size(sheet.cells, 1));
    for row = 1:numel(lines)
      fields = regexp([lines{row} ','], '("(?:[^"]|"")*"|[^,]*),', 'tokens');
      for k = 1:size(sheet.cells, 2)
        field = strrep(regexprep(fields{k}{1}, '^"|"$', ''), '""', '"');
        cell = sheet.cells{row, k};
        if ischar(cell)
          assert(cell, field);
        elseif isempty(cell)
          assert(isempty(field));
        else
          assert(cell(1), sscanf(field, '%g', 1), -1e-14);
          several += numel(cell) > 1;
          if numel(cell) == 1
            assert(sheet.matrix(row, k), cell);
          end
        end
      end
    end
  end
end
assert(several > 0);

wrong(@() whirl_table('m.h5', 'lowst'), 'did you mean lowest');
wrong(@() whirl_table('m.h5'), 'the name of a sheet');
wrong(@() whirl_table(3, 'lowest'), 'the name of a result file');
wrong(@() whirl_table('m.h5', 'lowest', 'units', 'rpn'), 'did you mean rpm');
wrong(@() whirl_statements('m.h5', 'colour', 'red'), 'no option');
wrong(@() whirl_statements([getenv('TESTS') '/cli/modes.yaml']), 'modes.yaml');
wrong(@() whirl_statements(), 'the name of a result file');
disp('all well');
