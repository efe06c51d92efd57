function found = whirl_fit(given_case, data, unknown, varargin)
% WHIRL_FIT  Fits parameters of a machine to measured motions.
%   FOUND = WHIRL_FIT(CASE, DATA, UNKNOWN) takes three arguments:
%     CASE     the text of a case, or the name of its file; its study is replaced
%     DATA     the name of a table (guide, chapter 18); or a cell of headings and columns, {'speed [rpm]', n,
%              'disc x [um]', x}; or a struct of an onset, a critical speed or a mode, struct('onset', '5200 rpm',
%              'noise', '50 rpm'); or a cell of such structs
%     UNKNOWN  a struct of the unknown parameters, each [] or [from to] in SI: struct('k', [0.6e6 2e6], 'e', [])
%
%   WHIRL_FIT(..., NAME, VALUE, ...) sets further keys of the study fit: 'starts', 'profile', 'loss', ...; and keys of
%   a table: 'noise', a number in metres or a text '2 um'; 'at', a struct of values in SI that parameters had in the
%   measurement; 'compare', which is 'statistics' for motions that are not periodic; 'runup', a struct of the keys of a
%   run at a changing speed in which the table was measured: struct('speed_from', '600 rpm', 'speed_to', '3000 rpm',
%   'rate', '400 rpm/s'). With it, 'compare' may be 'waveform' for displacements over the time, and 'delay' is the time
%   of the table at which the run begins: a number in s, or a text '0.2 s'.
%
%   Of an HDF5, MAT or universal file: 'columns', a cell of headings and datasets, variables or records, {'time [s]',
%   't', 'disc x [um]', 'signals[0, :]'}; of a data set: 'record', the number of a record.
%
%   FOUND has a struct for each unknown, with start, value, error, low and high (95 %), profile ([low high]) and known:
%   'determined', 'at a bound', 'weak' or 'unknown'; FOUND.result is that of WHIRL_RUN.
%
%   Errors: as those of WHIRL_RUN.
%
%   See also WHIRL_RUN.
if nargin < 3 || ~isstruct(unknown) || mod(numel(varargin), 2) ~= 0
    error('whirl:badInput', ...
          'whirl_fit takes a case, measured numbers, a struct of unknowns, and pairs of names and values');
end
text = text_of(given_case);
if ~any(text == 10)
    text = fileread(file_of(text));
end
written = '';
if iscell(data) && ischar(data{1})
    written = [tempname() '.csv'];
    write_columns(written, data);
    data = written;
end
fit = struct();
numbers = isstruct(data);
if numbers
    fit.data = {data};
elseif iscell(data)
    fit.data = data;
    numbers = true;
else
    item = struct('file', whole_path(text_of(data)));
end
for i = 1:2:numel(varargin)
    value = varargin{i + 1};
    if any(strcmp(varargin{i}, {'noise', 'at', 'compare', 'columns', 'record', 'runup', 'delay'}))
        if numbers
            error('whirl:badInput', '%s belongs to a table, and onsets and modes have it in their struct', varargin{i});
        elseif strcmp(varargin{i}, 'columns')
            value = containers.Map(value(1:2:end), value(2:2:end));
        elseif isnumeric(value) && strcmp(varargin{i}, 'delay')
            value = sprintf('%.17g s', value);
        elseif isnumeric(value) && ~strcmp(varargin{i}, 'record')
            value = sprintf('%.17g m', value);
        end
        item.(varargin{i}) = value;
    else
        fit.(varargin{i}) = value;
    end
end
names = fieldnames(unknown);
for i = 1:numel(names)
    bounds = unknown.(names{i});
    fit.unknown.(names{i}) = struct();
    if ~isempty(bounds)
        fit.unknown.(names{i}) = struct('from', bounds(1), 'to', bounds(2));
    end
end
if ~numbers
    fit.data = {item};
end
% JSON is YAML: the study in one line replaces that of the case.
kept = regexprep([text char(10)], '(?m)^study:.*\n(?:(?:[ \t#].*)?\n)*', '', 'dotexceptnewline');
kept = [kept 'study: ' jsonencode(struct('fit', fit)) char(10)];
try
    result = whirl_run(kept, 'progress', false);
catch problem
    forget(written);
    rethrow(problem);
end
forget(written);
found = struct('result', result);
words = {'determined', 'at a bound', 'weak', 'unknown'};
table = result.fit.fit;
[~, best] = min(table.outcome(:, 4));
rows = reshape(table.unknown, [], numel(names), 8);   % a single unknown has no dimension of its own
for i = 1:numel(names)
    row = reshape(rows(best, i, :), 1, []);
    own = struct('start', row(2), 'value', row(3), 'error', row(4), 'low', row(3) - row(5), 'high', row(3) + row(5));
    own.known = 'unknown';   % also where a motion or number was lost at the start
    if ~isnan(row(8))
        own.known = words{row(8) + 1};
    end
    own.profile = [NaN NaN];
    if isfield(table, 'profile')
        ends = reshape(table.profile, [], numel(names), 2);
        own.profile = reshape(ends(best, i, :), 1, []);
    end
    found.(names{i}) = own;
end
end

function write_columns(name, data)
stream = fopen(name, 'w');
fprintf(stream, '%s\n', strjoin(data(1:2:end), ', '));
columns = cell2mat(cellfun(@(column) column(:), data(2:2:end), 'UniformOutput', false));
form = [repmat('%.17g, ', 1, size(columns, 2) - 1) '%.17g\n'];
fprintf(stream, form, columns.');
fclose(stream);
end

function name = whole_path(name)
if isempty(regexp(name, '^(/|~|[A-Za-z]:)', 'once'))
    name = fullfile(pwd(), name);   % the case is run from elsewhere
end
end

function forget(name)
if ~isempty(name)
    delete(name);
end
end
