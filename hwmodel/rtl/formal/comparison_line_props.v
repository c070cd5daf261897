// What a line by comparison integration always does: every end point, every pattern of the pulse
// source.
module comparison_line_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] end_x,
    input wire [N-1:0] end_y,
    input wire [1:0]   negative
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative_q;
    wire         done;
    wire [N+1:0] d_q;
    wire [N-1:0] end_x_q, end_y_q, jex, jey;

    comparison_line #(.N(N)) line (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_end_x(end_x), .i_end_y(end_y),
        .i_d({2'b00, end_y} - {2'b00, end_x}), .i_negative(negative), .o_pulse(pulse),
        .o_negative(negative_q), .o_done(done), .o_d(d_q), .o_end_x(end_x_q), .o_end_y(end_y_q),
        .o_jex(jex), .o_jey(jey)
    );

    wire signed [N+3:0] d  = {{2{d_q[N+1]}}, d_q};
    wire signed [N+3:0] xe = {4'b0000, end_x_q};
    wire signed [N+3:0] ye = {4'b0000, end_y_q};

    // Pulses, and twice the time from the next one of y to the next one of x: each pulse takes the
    // other axis' way and is due in the middle.
    reg        [N-1:0] pulses_x = 0, pulses_y = 0;
    reg signed [N+3:0] later = 0;
    always @(posedge clk)
        if (first | load) begin
            pulses_x <= 0;
            pulses_y <= 0;
            later    <= first ? 0 : {4'b0000, end_y} - {4'b0000, end_x};
        end else begin
            pulses_x <= pulses_x + {{(N-1){1'b0}}, pulse[0]};
            pulses_y <= pulses_y + {{(N-1){1'b0}}, pulse[1]};
            later    <= later + (pulse[0] ? ye + ye : 0) - (pulse[1] ? xe + xe : 0);
        end

    always @* if (!first) begin
        // No pulse after the end, nor without the pulse source, and no step without a pulse.
        assert (!((done | ~en) & pulse != 0));
        assert (done | ~en | pulse != 0);
        // Pulses and counters together are the end point: done means there, exactly.
        assert (pulses_x + jex == end_x_q);
        assert (pulses_y + jey == end_y_q);
        if (done) assert (pulses_x == end_x_q && pulses_y == end_y_q);
        // D's range. (That no axis gets more pulses than the end point has is a matter of products,
        // and not claimed here.)
        if (end_x_q == 0 | end_y_q == 0) assert (d == ye - xe);
        else assert (d > -xe - xe && d < ye + ye);
        // D is that time; the earlier pulse is due, level ones both.
        assert (d == later);
        if (~done & en) assert (pulse == (d < 0 ? 2'b01 : d > 0 ? 2'b10 : 2'b11));
    end
endmodule
