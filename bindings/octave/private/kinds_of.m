function kinds = kinds_of(table, name, by_attractor)
% KINDS_OF  What the points of a table are told apart by in a figure: regimes, or attractors.
%   Members: of (the kind of every point), paleness (of every point, 0 to 1: regimes of little confidence are pale),
%   and for those kinds that are there, in the order of a legend: number, colours [kinds][3], names. [] where the points
%   have no verdicts.
FIELD = field_names();
kinds = [];
if by_attractor
    kinds = by_attractors(table, name);
elseif has_field(table, FIELD.regime_code)
    [names, colours] = regimes();
    confidence = field_of(table, FIELD.regime_confidence);
    confidence(isnan(confidence)) = 0;
    paleness = [0.6; 0.2; 0];
    kinds.of = regime_classes(table);
    kinds.paleness = paleness(confidence + 1);
    kinds.number = unique(kinds.of);
    kinds.colours = colours(kinds.number, :);
    kinds.names = names(kinds.number);
end
end

function kinds = by_attractors(table, name)
kinds.of = double(flat(table, table.attractor));
kinds.paleness = zeros(size(kinds.of));
[kinds.number, first] = unique(kinds.of, 'first');
% Those without a verdict last.
order = [find(kinds.number > 0); find(kinds.number == 0)];
kinds.number = kinds.number(order);
first = first(order);
kinds.colours = zeros(numel(order), 3);
kinds.names = cell(1, numel(order));
for i = 1:numel(order)
    kinds.colours(i, :) = attractor_colour(kinds.number(i));
    kinds.names{i} = attractor_name(table, name, kinds.number(i), first(i));
end
end

function words = attractor_name(table, name, number, point)
% Of a basin with its verdict and share, which are those of all its starts: 'attractor 1: P-5 (31 %)'.
FIELD = field_names();
words = sprintf('attractor %d', number);
if number == 0
    words = 'no verdict';
elseif strcmp(name, 'basin') && has_field(table, FIELD.regime_code)
    verdicts = flat(table, table.verdict.name);
    shares = flat(table, table.share);
    words = sprintf('%s: %s (%.3g %%)', words, verdicts{point}, 100 * shares(point));
end
end
