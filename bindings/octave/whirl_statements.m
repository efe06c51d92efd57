function statements = whirl_statements(file, varargin)
% WHIRL_STATEMENTS  Returns findings on machines at rest, branches, tori and spectra, as sentences.
%   STATEMENTS = WHIRL_STATEMENTS(FILE) takes the name of a result file (.h5), or a struct of WHIRL_READ. STATEMENTS is
%   a struct array [statements x 1] whose fields are texts:
%     table    the table of the result
%     what     'separation margin'
%     station  or ''
%     at       the value of the table's parameter; '' for the whole table
%     verdict  'none asked for', 'holds', 'not known' or 'fails'
%     clause   of the standard with the requirement, or ''
%     asked    the requirement, or ''
%     found    the value found
%     judged   the verdict with its reason, or ''
%     text     the statement as one sentence
%   and values, a struct whose fields at, asked, found and judged are columns with the numbers of these texts in SI.
%   WHIRL_STATEMENTS(FILE, 'units', 'um, rpm, p-p') writes numbers in these units, not those of the case.
%
%   Errors: whirl:badInput for a file that is no result, and for unknown units; whirl:noCommand.
%
%   See also WHIRL_TABLE, WHIRL_READ.
if nargin < 1
    error('whirl:badInput', 'whirl_statements takes the name of a result file, or what whirl_read gives');
end
found = findings_of('whirl_statements', file, '', varargin);
texts = {'table', 'what', 'station', 'at', 'verdict', 'clause', 'asked', 'found', 'judged', 'text'};
blank = [texts; repmat({''}, size(texts))];
blank = struct(blank{:}, 'values', struct('at', [], 'asked', [], 'found', [], 'judged', []));
list = list_of(found.statements);
statements = repmat(blank, numel(list), 1);
for i = 1:numel(list)
    names = fieldnames(list{i});
    for k = 1:numel(names)
        value = list{i}.(names{k});
        if isstruct(value)
            statements(i).values.(names{k}) = value.values(:);
            value = value.text;
        end
        statements(i).(names{k}) = value;
    end
end
end
