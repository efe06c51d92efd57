function statements = whirl_statements(file, varargin)
% WHIRL_STATEMENTS  What was found of machines at rest, of branches, tori and spectra, in sentences.
%   STATEMENTS = WHIRL_STATEMENTS(FILE) takes the name of a result file (.h5), or what WHIRL_READ gave. It is a struct
%   array [statements x 1] whose fields are texts:
%     table    the table of the result that it is of
%     what     'separation margin'
%     station  or ''
%     at       the value of the table's parameter that it is of; '' of the whole table
%     verdict  'none asked for', 'holds', 'not known' or 'fails'
%     clause   of the standard that asks for it, or ''
%     asked    what is asked for, or ''
%     found    what was found
%     told     the verdict with its reason, or ''
%     text     all of it as one sentence
%   and values, a struct with the numbers of at, asked, found and told in SI, a column each.
%   WHIRL_STATEMENTS(FILE, 'units', 'um, rpm, p-p') tells numbers in these units in the place of those of the case.
%
%   Errors: whirl:badInput for a file that is no result, or units that are none; whirl:noCommand.
%
%   See also WHIRL_TABLE, WHIRL_READ.
if nargin < 1
    error('whirl:badInput', 'whirl_statements takes the name of a result file, or what whirl_read gives');
end
found = findings_of('whirl_statements', file, '', varargin);
texts = {'table', 'what', 'station', 'at', 'verdict', 'clause', 'asked', 'found', 'told', 'text'};
blank = [texts; repmat({''}, size(texts))];
blank = struct(blank{:}, 'values', struct('at', [], 'asked', [], 'found', [], 'told', []));
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
