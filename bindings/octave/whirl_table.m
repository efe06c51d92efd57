function sheet = whirl_table(file, name, varargin)
% WHIRL_TABLE  Returns a sheet of findings, as documents show it.
%   SHEET = WHIRL_TABLE(FILE, NAME) takes the name of a result file (.h5), or a struct of WHIRL_READ, and the name of a
%   sheet, such as 'peaks', or 'TABLE/peaks' if several tables have such a sheet. WHIRL_TABLE(FILE, 'list') prints all
%   names, and NAMES = WHIRL_TABLE(FILE, 'list') returns them. SHEET is a struct:
%     name, table, title, about   texts
%     keys      {1 x columns} short names of the columns: 'speed'
%     headings  {1 x columns} printed headings without units: 'peak at'
%     units     {1 x columns} of the numbers, '' without a unit: 'rpm'
%     sizes     [1 x columns] of these units in SI
%     cells     {rows x columns} numbers in these units, texts, or columns of several numbers; [] for an empty cell
%     texts     {rows x columns} the cells as documents write them
%     matrix    [rows x columns] the cells that are one number; NaN for all other cells
%   WHIRL_TABLE(FILE, NAME, 'units', 'um, rpm, p-p') uses these units, not those of the case.
%
%   Errors: whirl:badInput for a file that is no result, and for an unknown sheet or unit; whirl:noCommand.
%
%   See also WHIRL_STATEMENTS, WHIRL_READ.
if nargin < 2 || ~is_text(text_of(name)) || isempty(text_of(name))
    error('whirl:badInput', ...
        'whirl_table takes the name of a result file, or what whirl_read gives, and the name of a sheet or ''list''');
end
name = text_of(name);
if strcmp(name, 'list')
    names = findings_of('whirl_table', file, '', varargin);
    list = list_of(names.sheets);
    own = cellfun(@(one) one.name, list, 'UniformOutput', false);
    sheet = own;
    for i = 1:numel(list)
        if sum(strcmp(own{i}, own)) > 1
            sheet{i} = [list{i}.table '/' own{i}];
        end
        if nargout == 0
            fprintf('%-32s %s\n', sheet{i}, list{i}.title);
        end
    end
    if nargout == 0
        clear sheet
    end
    return
end
found = findings_of('whirl_table', file, name, varargin);
columns = list_of(found.columns);
of = @(key) cellfun(@(column) column.(key), columns(:)', 'UniformOutput', false);
sheet = struct('name', found.name, 'table', found.table, 'title', found.title, 'about', '', 'keys', {of('key')}, ...
    'headings', {of('heading')}, 'units', {of('unit')}, 'sizes', [], 'cells', {{}}, 'texts', {{}}, 'matrix', []);
if isfield(found, 'about')
    sheet.about = found.about;
end
sheet.sizes = cell2mat(of('size'));
sheet.cells = cells_of(found.rows, numel(columns));
sheet.texts = cells_of(found.shown, numel(columns));
for k = 1:numel(columns)
    for i = 1:size(sheet.cells, 1)
        if isnumeric(sheet.cells{i, k})
            sheet.cells{i, k} = sheet.cells{i, k} / sheet.sizes(k);
        end
    end
end
sheet.matrix = NaN(size(sheet.cells));
single_numbers = cellfun(@(one) isnumeric(one) && numel(one) == 1, sheet.cells);
sheet.matrix(single_numbers) = [sheet.cells{single_numbers}];
end

function cells = cells_of(rows, columns)
% Returns the cells of rows. jsondecode makes one array of rows that have only numbers, and a list of other rows.
cells = cell(size(rows, 1), columns);
for i = 1:size(rows, 1)
    row = rows(i, :, :);
    if iscell(row)
        row = row{1};
    end
    for k = 1:columns
        if iscell(row)
            own = row{k};
        elseif size(row, 1) == 1
            own = reshape(row(1, k, :), [], 1);
        else
            own = reshape(row(k, :), [], 1);
        end
        if isnumeric(own) && isequaln(own, NaN)
            own = [];
        end
        cells{i, k} = own;
    end
end
end
