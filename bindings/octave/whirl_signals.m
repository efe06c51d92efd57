function signals = whirl_signals(file, records)
% WHIRL_SIGNALS  Reads signals of a data set, some records at a time, as all may be larger than the memory.
%   S = WHIRL_SIGNALS(FILE, RECORDS) is an array (class single) [samples][channels][records] of the rows RECORDS, from
%   1, of a result of a study `dataset`; without RECORDS of all rows. Plot the second channel of row 7: plot(S(:, 2,
%   7)).
%
%   SIZES = WHIRL_SIGNALS(FILE, 'size') is [records channels samples].
%
%   Rows are those of WHIRL_READ(FILE).records: dataset.label, dataset.severity, dataset.split, ...
%
%   Errors: whirl:badInput for a file without signals, and for rows that it does not have.
%
%   See also WHIRL_READ, WHIRL_RUN.
if nargin < 1 || nargin > 2 || ~ischar(text_of(file))
    error('whirl:badInput', 'whirl_signals takes the name of a file, and rows of records');
end
file = file_of(text_of(file));
if ~exist(file, 'file')
    error('whirl:badInput', 'there is no file %s', file);
end
sizes = whirl_mex('signals', file);
if nargin == 2 && ischar(text_of(records))
    if ~strcmp(text_of(records), 'size')
        error('whirl:badInput', 'records are ''%s'', expected rows from 1, or ''size''', text_of(records));
    end
    signals = sizes;
    return
end
if nargin < 2
    records = 1:sizes(1);
end
rows = double(records(:)');
if ~isnumeric(records) || any(rows ~= round(rows)) || any(rows < 1) || any(rows > sizes(1))
    error('whirl:badInput', 'records are chosen by numbers, expected rows from 1 to %d', sizes(1));
end
signals = zeros(sizes(3), sizes(2), numel(rows), 'single');
% Read consecutive rows at once.
ends = [find(diff(rows) ~= 1), numel(rows)];
first = 1;
for last = ends(ends > 0)
    signals(:, :, first:last) = whirl_mex('signals', file, rows(first) - 1, last - first + 1);
    first = last + 1;
end
end
