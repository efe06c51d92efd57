function subject = subject_of(result, field, analysis, table, station, every)
% SUBJECT_OF  What a figure is drawn of: the result, its table with a field, and a station.
%   Its members are result, table, name (of the table), index and station (number and name of the station), values (of
%   the parameter at every point, in its unit), label (of their axis), and lengths (what lengths of every point are
%   multiplied by). Details are drawn where they are named, or with EVERY.
subject.result = result_of(result);
[subject.table, subject.name] = table_with(subject.result, field, analysis, table, nargin > 5 && every);
subject.index = station_index(subject.result, station);
subject.station = subject.result.stations.name{subject.index};
parameter = subject.table.attributes.parameter;
subject.values = flat(subject.table, subject.table.values) / parameter_unit(subject.result, parameter);
if isempty(parameter)
    % Where nothing varies points stand over their numbers.
    subject.values = flat(subject.table, double(subject.table.point));
end
subject.label = parameter_label(subject.result, parameter);
subject.lengths = length_factors(subject.result, subject.table);
end
